//! Reading logs: whole, cut off, or one chunk of a log that is still being written.

use std::fs::File;
use std::io::{self, BufReader, ErrorKind, Read, Seek, SeekFrom};
use std::path::{Path, PathBuf};
use std::vec;

use mcap::read::ChunkReader;
use mcap::records::{Record, op};
use mcap::{MAGIC, McapError, parse_record};

use super::record::{LogHeader, LogRecord, RawMessage, TICK_NS, Topic};
use super::{StoreError, chunk::Contents};

/// No chunk of ours comes near this; a greater number in a file is damage, not a size to reserve.
const MOST_CHUNK_BYTES: u64 = 256 << 20;

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
            let Some((opcode, body)) = self.next_raw()? else { break };
            let messages = match opcode {
                op::CHUNK | op::MESSAGE => self.messages_of(opcode, &body)?,
                op::CHANNEL => self.check_channel(&body).map(|()| Vec::new())?,
                op::DATA_END => {
                    self.ended = true;
                    break;
                }
                _ => continue,
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

    /// The next record's opcode and bytes; none where the file was cut off.
    fn next_raw(&mut self) -> Result<Option<(u8, Vec<u8>)>, StoreError> {
        let Some((opcode, length)) = self.next_head()? else {
            (self.ended, self.cut_off) = (true, true);
            return Ok(None);
        };
        let mut body = vec![0; length as usize];
        self.file.read_exact(&mut body).map_err(|e| StoreError::file("read", &self.path, &e))?;
        self.position += 9 + length;
        Ok(Some((opcode, body)))
    }

    /// The next record's opcode and length, if all of it is there. The file stands after the head.
    fn next_head(&mut self) -> Result<Option<(u8, u64)>, StoreError> {
        if self.size.saturating_sub(self.position) < 9 {
            return Ok(None);
        }
        let mut head = [0; 9];
        self.file.read_exact(&mut head).map_err(|e| StoreError::file("read", &self.path, &e))?;
        let [opcode, length @ ..] = head;
        let length = u64::from_le_bytes(length);
        Ok((length <= self.size - self.position - 9).then_some((opcode, length)))
    }

    fn pass_message_indexes(&mut self) -> Result<(), StoreError> {
        loop {
            let head = self.next_head()?;
            match head {
                Some((op::MESSAGE_INDEX, length)) => self.skip_to(self.position + 9 + length)?,
                _ => return self.skip_to(self.position),
            }
        }
    }

    fn messages_of(&self, opcode: u8, body: &[u8]) -> Result<Vec<RawMessage>, StoreError> {
        messages_in(opcode, body).map_err(|e| self.damaged(&e.to_string()))
    }

    fn check_channel(&self, body: &[u8]) -> Result<(), StoreError> {
        let record = parse_record(op::CHANNEL, body).map_err(|e| self.damaged(&e.to_string()))?;
        check_ours(&record).map_err(|e| not_a_log(&self.path, e.to_string()))
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
    let Some((opcode, body)) = first_record(&bytes) else {
        return Err(damaged("no whole chunk where the index has one".into()));
    };
    messages_in(opcode, body).map_err(|e| damaged(e.to_string()))
}

fn first_record(bytes: &[u8]) -> Option<(u8, &[u8])> {
    let (&opcode, rest) = bytes.split_first()?;
    let (length, rest) = rest.split_first_chunk()?;
    let length = usize::try_from(u64::from_le_bytes(*length)).ok()?;
    Some((opcode, rest.get(..length)?))
}

fn messages_in(opcode: u8, body: &[u8]) -> Result<Vec<RawMessage>, McapError> {
    let mut messages = Vec::new();
    match parse_record(opcode, body)? {
        Record::Chunk { header, data } => {
            if header.uncompressed_size > MOST_CHUNK_BYTES {
                return Err(McapError::ChunkBufferTooLarge(header.uncompressed_size));
            }
            for record in ChunkReader::new(header, &data)? {
                let record = record?;
                check_ours(&record)?;
                messages.extend(message(record));
            }
        }
        record => messages.extend(message(record)),
    }
    Ok(messages)
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
        _ => Ok(()),
    }
}

fn not_a_log(path: &Path, reason: String) -> StoreError {
    StoreError::NotALog { path: path.to_path_buf(), reason }
}
