//! A disk that takes no more.

use std::fs::{self, File};
use std::io::{self, ErrorKind, Write};

use super::fixture::*;
use crate::store::log_file::LogFile;
use crate::store::{LogWriter, Store, StoreError};

/// A file on a disk with little room: it takes what fits, in part if need be, and refuses the rest.
struct SmallDisk {
    file: File,
    room: usize,
}

impl Write for SmallDisk {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        if self.room == 0 {
            return Err(ErrorKind::StorageFull.into());
        }
        let taken = self.file.write(&bytes[..bytes.len().min(self.room)])?;
        self.room -= taken;
        Ok(taken)
    }

    fn flush(&mut self) -> io::Result<()> {
        self.file.flush()
    }
}

fn create_on_small_disk(store: &Store, room: usize) -> Result<LogWriter, StoreError> {
    let path = store.log_path(ID);
    let file = File::create(&path).expect("a file");
    let disk = SmallDisk { file: file.try_clone().expect("the file again"), room };
    let (log, first) = LogFile::on_disk(&path, file, Box::new(disk), &header())?;
    store.replace_chunks(ID, &[first], || Ok(()))?;
    LogWriter::start(store, ID, log)
}

#[test]
fn a_full_disk_is_reported_and_leaves_what_was_stored() {
    let (_folder, store) = store();
    let writer = create_on_small_disk(&store, 40_000).expect("the header fits");
    let all = run(2000);
    let parts: Vec<_> = all.chunks(24).collect();
    let stored = parts.iter().take_while(|part| write(&writer, part).is_ok()).count();
    assert!(stored > 0 && stored < parts.len(), "{stored} parts fit");
    let reported = writer.write(all[0].clone()).expect_err("the writer has failed");
    assert!(reported.to_string().contains("free some space"), "{reported}");
    assert_eq!(writer.flush(), Err(reported.clone()), "it stays reported");
    assert_eq!(writer.finish(), Err(reported));

    let expected = &all[..24 * stored];
    assert_eq!(read_all(&store.log_path(ID)), expected);
    let row = store.session(ID).expect("readable").expect("there");
    assert_eq!(store.ticks(ID, 1, u64::MAX), Ok(ticks(1, row.tick)));
    assert_eq!(store.recover(ID).map(|recovered| recovered.tick), Ok(row.tick));
}

#[test]
fn a_full_disk_at_the_start_is_reported() {
    for room in [0, 5, 1000] {
        let (_folder, store) = store();
        let refused = create_on_small_disk(&store, room).map(drop).expect_err("no room");
        assert!(refused.to_string().contains("free some space"), "room {room}: {refused}");
    }
}

#[cfg(target_os = "linux")]
#[test]
fn the_system_s_own_full_disk_is_reported() {
    let (_folder, store) = store();
    let full = File::options().write(true).open("/dev/full").expect("Linux has it");
    let disk = full.try_clone().expect("the device again");
    let refused = LogFile::on_disk("/dev/full".as_ref(), full, Box::new(disk), &header());
    let refused = refused.map(drop).expect_err("no room");
    assert!(refused.to_string().contains("/dev/full"), "{refused}");
    assert!(refused.to_string().contains("free some space"), "{refused}");
    assert_eq!(fs::read_dir(store.session_folder(ID)).expect("readable").count(), 0);
}
