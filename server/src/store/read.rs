//! Reading logs: whole, cut off, or one chunk of a log that is still being written.

use std::fs::File;
use std::io::{self, BufReader, ErrorKind, Read, Seek, SeekFrom};
use std::path::{Path, PathBuf};
use std::vec;

use mcap::records::{Record, op};
use mcap::sans_io::linear_reader::{LinearReadEvent, LinearReader, LinearReaderOptions};
use mcap::{MAGIC, McapError, parse_record};

use super::record::{LogHeader, LogRecord, RawMessage, TICK_NS, Topic};
use super::{StoreError, chunk::Contents};

/// No chunk of ours comes near this; a greater number in a file is damage, not a size to reserve.
const MOST_CHUNK_BYTES: u64 = 256 << 20;

/// A record starts with its opcode and its length.
const HEAD_BYTES: u64 = 1 + 8;

/// What the record at the end of the data holds.
const CHECKSUM_BYTES: u64 = 4;

/// Opens a whole log, finished or cut off. Memory stays at one chunk, however long the log is.
pub fn read_log(path: &Path) -> Result<LogReader, StoreError> {
    LogReader::open(path)
}

/// The records of a log in order. After damage it yields one error and ends.
#[derive(Debug)]
pub struct LogReader {
    blocks: Blocks,
    header: Option<LogHeader>,
    messages: vec::IntoIter<RawMessage>,
}

impl LogReader {
    pub(super) fn open(path: &Path) -> Result<Self, StoreError> {
        let mut blocks = Blocks::open(path)?;
        let first = blocks.next_block()?.map(|block| block.messages).unwrap_or_default();
        let header = match first.first() {
            Some(message) if message.topic == Topic::Session => {
                let header = serde_json::from_slice(&message.data);
                Some(
                    header
                        .map_err(|e| not_a_log(path, format!("its header is unreadable: {e}")))?,
                )
            }
            Some(_) => return Err(not_a_log(path, "it has no session header".into())),
            None => None,
        };
        Ok(Self { blocks, header, messages: first.into_iter() })
    }

    /// What the session ran with; none when the log was cut off before it.
    pub fn header(&self) -> Option<&LogHeader> {
        self.header.as_ref()
    }

    /// Whether the part read so far ends without the log having been finished. Meaningful once the
    /// iterator has ended.
    pub fn is_cut_off(&self) -> bool {
        self.blocks.is_cut_off()
    }

    fn next_record(&mut self) -> Result<Option<LogRecord>, StoreError> {
        loop {
            for message in self.messages.by_ref() {
                let decoded = message.decode();
                if let Some(record) = decoded.map_err(|e| self.blocks.damaged(&e.to_string()))? {
                    return Ok(Some(record));
                }
            }
            match self.blocks.next_block()? {
                Some(block) => self.messages = block.messages.into_iter(),
                None => return Ok(None),
            }
        }
    }
}

impl Iterator for LogReader {
    type Item = Result<LogRecord, StoreError>;

    fn next(&mut self) -> Option<Self::Item> {
        let record = self.next_record();
        if record.is_err() {
            self.messages = Vec::new().into_iter();
            self.blocks.ended = true;
        }
        record.transpose()
    }
}

/// A chunk as it was read.
#[derive(Debug)]
pub(super) struct Block {
    pub(super) offset: u64,
    /// Bytes, the message indexes that follow included.
    pub(super) length: u64,
    pub(super) messages: Vec<RawMessage>,
}

/// The chunks of a log, from its start to its end or to where it was cut off.
#[derive(Debug)]
pub(super) struct Blocks {
    path: PathBuf,
    file: BufReader<File>,
    /// Bytes in the file when it was opened.
    size: u64,
    position: u64,
    block_start: u64,
    ended: bool,
    cut_off: bool,
}

impl Blocks {
    pub(super) fn open(path: &Path) -> Result<Self, StoreError> {
        let failed = |e: io::Error| StoreError::file("read", path, &e);
        let file = File::open(path).map_err(failed)?;
        let size = file.metadata().map_err(failed)?.len();
        let mut file = BufReader::new(file);
        let mut magic = Vec::new();
        file.by_ref().take(MAGIC.len() as u64).read_to_end(&mut magic).map_err(failed)?;
        if !MAGIC.starts_with(&magic) {
            return Err(not_a_log(path, "it does not start like an MCAP file".into()));
        }
        let position = magic.len() as u64;
        let path = path.to_path_buf();
        Ok(Self { path, file, size, position, block_start: 0, ended: false, cut_off: false })
    }

    /// Continues at `offset`, the end of a chunk known from the index.
    pub(super) fn skip_to(&mut self, offset: u64) -> Result<(), StoreError> {
        self.position = offset;
        let sought = self.file.seek(SeekFrom::Start(offset));
        sought.map(drop).map_err(|e| StoreError::file("read", &self.path, &e))
    }

    pub(super) fn next_block(&mut self) -> Result<Option<Block>, StoreError> {
        while !self.ended {
            self.block_start = self.position;
            let Some(record) = self.next_raw()? else { break };
            let messages = match record[0] {
                op::CHUNK | op::MESSAGE | op::CHANNEL => self.messages_of(&record)?,
                op::DATA_END if record.len() as u64 == HEAD_BYTES + CHECKSUM_BYTES => {
                    self.ended = true;
                    break;
                }
                _ => {
                    check_passed(&record).map_err(|reason| self.damaged(&reason))?;
                    continue;
                }
            };
            if messages.is_empty() {
                continue;
            }
            self.pass_message_indexes()?;
            let length = self.position - self.block_start;
            return Ok(Some(Block { offset: self.block_start, length, messages }));
        }
        Ok(None)
    }

    /// The bytes of the next record, opcode and length included; none where the file was cut off.
    fn next_raw(&mut self) -> Result<Option<Vec<u8>>, StoreError> {
        let Some((_, length)) = self.next_head()? else {
            (self.ended, self.cut_off) = (true, true);
            return Ok(None);
        };
        self.skip_to(self.position)?;
        let mut record = vec![0; (HEAD_BYTES + length) as usize];
        self.file.read_exact(&mut record).map_err(|e| StoreError::file("read", &self.path, &e))?;
        self.position += HEAD_BYTES + length;
        Ok(Some(record))
    }

    /// The next record's opcode and length, if all of it is there. The file stands after the head.
    fn next_head(&mut self) -> Result<Option<(u8, u64)>, StoreError> {
        if self.size.saturating_sub(self.position) < HEAD_BYTES {
            return Ok(None);
        }
        let mut head = [0; HEAD_BYTES as usize];
        self.file.read_exact(&mut head).map_err(|e| StoreError::file("read", &self.path, &e))?;
        let [opcode, length @ ..] = head;
        let length = u64::from_le_bytes(length);
        Ok((length <= self.size - self.position - HEAD_BYTES).then_some((opcode, length)))
    }

    fn pass_message_indexes(&mut self) -> Result<(), StoreError> {
        let mut end = self.position;
        while let Some((op::MESSAGE_INDEX, _)) = self.next_head()? {
            self.skip_to(self.position)?;
            let record = self.next_raw()?.unwrap_or_default();
            if check_passed(&record).is_err() {
                break;
            }
            end = self.position;
        }
        // What is no index is looked at again, as a record of its own.
        self.skip_to(end)
    }

    fn messages_of(&self, record: &[u8]) -> Result<Vec<RawMessage>, StoreError> {
        messages_in(record).map_err(|e| match e {
            McapError::ConflictingChannels(topic) => {
                not_a_log(&self.path, format!("it has a channel {topic}"))
            }
            e => self.damaged(&e.to_string()),
        })
    }

    /// Whether the file ended before it was finished. Known once all blocks are read.
    pub(super) fn is_cut_off(&self) -> bool {
        self.cut_off
    }

    pub(super) fn damaged(&self, reason: &str) -> StoreError {
        let (path, offset) = (self.path.clone(), self.block_start);
        StoreError::Damaged { path, offset, reason: reason.into() }
    }
}

impl Block {
    /// What the index keeps of it.
    pub(super) fn contents(&self) -> serde_json::Result<Contents> {
        Contents::of_messages(&self.messages)
    }
}

/// The messages of one chunk whose place is known from the index.
pub(super) fn read_extent(
    file: &mut File,
    path: &Path,
    (offset, length): (u64, u64),
) -> Result<Vec<RawMessage>, StoreError> {
    let damaged = |reason: String| {
        let path = path.to_path_buf();
        StoreError::Damaged { path, offset, reason }
    };
    let failed = |e: io::Error| match e.kind() {
        ErrorKind::UnexpectedEof => damaged("the file is shorter than its index says".into()),
        _ => StoreError::file("read", path, &e),
    };
    if length > MOST_CHUNK_BYTES {
        return Err(damaged(format!("the index gives it {length} bytes")));
    }
    let mut bytes = vec![0; length as usize];
    file.seek(SeekFrom::Start(offset)).map_err(failed)?;
    file.read_exact(&mut bytes).map_err(failed)?;
    messages_in(&bytes).map_err(|e| damaged(e.to_string()))
}

/// The messages of a chunk, its indexes behind it or not, or of a message outside of all chunks.
///
/// The checksum is compared before anything inside a chunk is believed, and no length in the file
/// reserves more than [`MOST_CHUNK_BYTES`].
fn messages_in(mut record: &[u8]) -> Result<Vec<RawMessage>, McapError> {
    if record.first() == Some(&op::CHUNK) {
        demand_checksum(record)?;
    }
    let mut reader = LinearReader::new_with_options(
        LinearReaderOptions::default()
            .with_skip_start_magic(true)
            .with_skip_end_magic(true)
            .with_prevalidate_chunk_crcs(true)
            .with_record_length_limit(MOST_CHUNK_BYTES as usize),
    );
    let mut messages = Vec::new();
    while let Some(event) = reader.next_event() {
        match event? {
            LinearReadEvent::ReadRequest(wanted) => {
                let part = record.split_off(..wanted.min(record.len())).unwrap_or_default();
                reader.insert(part.len()).copy_from_slice(part);
                reader.notify_read(part.len());
            }
            LinearReadEvent::Record { data, opcode } => {
                let inner = parse_record(opcode, data)?;
                check_ours(&inner)?;
                messages.extend(message(inner));
            }
        }
    }
    Ok(messages)
}

/// Whether a record may be passed over. A chunk must not be, whatever damage makes its opcode.
fn check_passed(record: &[u8]) -> Result<(), String> {
    let opcode = record.first().copied().unwrap_or_default();
    let body = record.get(HEAD_BYTES as usize..).unwrap_or_default();
    let is_whole = match opcode {
        // Channel, bytes of what follows, and that: nothing else is so long as it says.
        op::MESSAGE_INDEX => body.get(2..6).is_some_and(|length| {
            let length = length.iter().rev().fold(0, |sum, byte| sum << 8 | usize::from(*byte));
            length + 6 == body.len()
        }),
        op::HEADER | op::SCHEMA | op::ATTACHMENT | op::METADATA => {
            parse_record(opcode, body).is_ok()
        }
        _ => return Err(format!("a record of kind {opcode:#04x} stands there")),
    };
    is_whole.then_some(()).ok_or_else(|| format!("a record of kind {opcode:#04x} is broken"))
}

/// MCAP allows a chunk without a checksum; this program writes none.
fn demand_checksum(chunk: &[u8]) -> Result<(), McapError> {
    let body = chunk.get(HEAD_BYTES as usize..).ok_or(McapError::UnexpectedEof)?;
    match parse_record(op::CHUNK, body)? {
        Record::Chunk { header, .. } if header.uncompressed_crc == 0 => {
            Err(McapError::BadChunkCrc { saved: 0, calculated: 0 })
        }
        _ => Ok(()),
    }
}

fn message(record: Record<'_>) -> Option<RawMessage> {
    let Record::Message { header, data } = record else { return None };
    let topic = Topic::from_number(header.channel_id)?;
    Some(RawMessage { topic, tick: header.log_time / TICK_NS, data: data.into_owned() })
}

/// Channels have fixed numbers, so a file that numbers them otherwise is somebody else's.
fn check_ours(record: &Record<'_>) -> Result<(), McapError> {
    match record {
        Record::Channel(channel) => match Topic::from_number(channel.id) {
            Some(topic) if topic.name() == channel.topic => Ok(()),
            _ => Err(McapError::ConflictingChannels(channel.topic.clone())),
        },
        Record::Message { header, .. } if Topic::from_number(header.channel_id).is_none() => {
            Err(McapError::UnknownChannel(header.sequence, header.channel_id))
        }
        _ => Ok(()),
    }
}

fn not_a_log(path: &Path, reason: String) -> StoreError {
    StoreError::NotALog { path: path.to_path_buf(), reason }
}
