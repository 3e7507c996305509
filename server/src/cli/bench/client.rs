//! A server of its own for a measurement, and the least that talks to it. The client is in another
//! process than the server, so that only the server is measured.

use std::io::{self, BufRead, BufReader, Read, Write};
use std::net::TcpStream;
use std::path::Path;
use std::process::{Child, Command, Stdio};
use std::thread::{self, JoinHandle};

use serde_json::Value as Json;

use super::Failure;

/// A server that lives as long as this.
pub(super) struct Server {
    process: Child,
    address: String,
}

impl Server {
    /// This same program, serving a folder on a free port.
    pub(super) fn start(data: &Path) -> Result<Self, Failure> {
        let mut process = Command::new(std::env::current_exe()?)
            .args(["serve", "--listen", "127.0.0.1:0", "--data"])
            .arg(data)
            .env("SONARIUM_RENDERER", "cpu")
            .stdout(Stdio::piped())
            .spawn()?;
        let output = process.stdout.take().ok_or_else(|| failed("the server has no output"))?;
        let address = BufReader::new(output).lines().map_while(Result::ok).find_map(|line| {
            let rest = line.split_once("open http://")?.1;
            rest.split_whitespace().next().map(str::to_owned)
        });
        let address = address.ok_or_else(|| failed("the server did not say where it listens"))?;
        Ok(Self { process, address })
    }

    /// The body of a GET.
    pub(super) fn get(&self, path: &str) -> Result<String, Failure> {
        self.request("GET", path, "")
    }

    /// The answer to a POST.
    pub(super) fn post(&self, path: &str, body: &Json) -> Result<Json, Failure> {
        let answer = self.request("POST", path, &body.to_string())?;
        serde_json::from_str(&answer).map_err(|error| failed(&format!("{error} in {answer}")))
    }

    /// A number from `/metrics`.
    pub(super) fn metric(&self, name: &str) -> Result<f64, Failure> {
        let metrics = self.get("/metrics")?;
        let value = metrics.lines().find_map(|line| line.strip_prefix(name)?.trim().parse().ok());
        value.ok_or_else(|| failed(&format!("/metrics has no {name} on this system")))
    }

    /// A viewer that subscribes and then reads whatever comes, until the server ends.
    pub(super) fn watch(&self, id: &str, subscribe: &str) -> Result<Watcher, Failure> {
        let mut socket = TcpStream::connect(&self.address)?;
        write!(
            socket,
            "GET /api/v1/sessions/{id}/stream HTTP/1.1\r\nHost: {}\r\nConnection: Upgrade\r\n\
             Upgrade: websocket\r\nSec-WebSocket-Version: 13\r\n\
             Sec-WebSocket-Key: dGhlIHNhbXBsZSBub25jZQ==\r\n\r\n",
            self.address
        )?;
        socket.write_all(&text_frame(subscribe))?;
        let mut reader = socket.try_clone()?;
        let reading = thread::spawn(move || io::copy(&mut reader, &mut io::sink()).unwrap_or(0));
        Ok(Watcher { socket, reading })
    }

    fn request(&self, method: &str, path: &str, body: &str) -> Result<String, Failure> {
        let mut socket = TcpStream::connect(&self.address)?;
        write!(
            socket,
            "{method} {path} HTTP/1.1\r\nHost: {}\r\nConnection: close\r\n\
             Content-Type: application/json\r\nContent-Length: {}\r\n\r\n{body}",
            self.address,
            body.len()
        )?;
        let mut answer = String::new();
        socket.read_to_string(&mut answer)?;
        let (head, body) = answer.split_once("\r\n\r\n").ok_or_else(|| failed("half an answer"))?;
        let status = head.split_whitespace().nth(1).unwrap_or_default();
        if status.starts_with('2') {
            return Ok(body.to_owned());
        }
        Err(failed(&format!("{method} {path} answered {status}: {body}")))
    }
}

impl Drop for Server {
    fn drop(&mut self) {
        // The folder goes with the measurement, so nothing has to be put down in order.
        let _ = self.process.kill();
        let _ = self.process.wait();
    }
}

/// A viewer at work.
pub(super) struct Watcher {
    socket: TcpStream,
    reading: JoinHandle<u64>,
}

impl Watcher {
    /// Leaves; gives the bytes it was sent.
    pub(super) fn leave(self) -> u64 {
        // A socket that is closed already is as good.
        let _ = self.socket.shutdown(std::net::Shutdown::Both);
        self.reading.join().unwrap_or(0)
    }
}

/// A masked text frame (RFC 6455 section 5.2), the mask being zero.
fn text_frame(text: &str) -> Vec<u8> {
    let length = u16::try_from(text.len()).unwrap_or(u16::MAX);
    let mut frame = vec![0x81, 0xFE];
    frame.extend(length.to_be_bytes());
    frame.extend([0; 4]);
    frame.extend(text.as_bytes());
    frame
}

fn failed(text: &str) -> Failure {
    Failure::Failed(text.to_owned())
}
