//! A running server on its own port and data folder.

use std::io::{BufRead, BufReader};
use std::path::{Path, PathBuf};
use std::process::{Child, Command, Stdio};
use std::time::{Duration, Instant};

use serde_json::Value;
use tempfile::TempDir;

/// Longest that anything here is waited for.
const PATIENCE: Duration = Duration::from_secs(60);

/// The real binary, serving on a free port of loopback. Ended when dropped.
#[derive(Debug)]
pub struct Server {
    child: Child,
    url: String,
    data: PathBuf,
    _folder: Option<TempDir>,
}

impl Server {
    /// Starts on a data folder of its own.
    #[must_use]
    pub fn start() -> Self {
        let folder = tempfile::tempdir().expect("a temporary folder");
        let mut server = Self::start_on(folder.path());
        server._folder = Some(folder);
        server
    }

    /// Starts on a data folder that outlives it.
    #[must_use]
    pub fn start_on(data: &Path) -> Self {
        let mut child = Command::new(crate::binary())
            .args(["serve", "--listen", "127.0.0.1:0", "--data"])
            .arg(data)
            .stdout(Stdio::piped())
            .stderr(Stdio::null())
            .spawn()
            .expect("the binary can be started");
        let stdout = child.stdout.take().expect("stdout is piped");
        let url = BufReader::new(stdout)
            .lines()
            .map_while(Result::ok)
            .find_map(|line| address_in(&line))
            .expect("the server prints its address");
        Self { child, url, data: data.into(), _folder: None }
    }

    /// Address of the page, without a slash at the end.
    #[must_use]
    pub fn url(&self) -> &str {
        &self.url
    }

    /// The data folder.
    #[must_use]
    pub fn data(&self) -> &Path {
        &self.data
    }

    /// Process id.
    #[must_use]
    pub fn pid(&self) -> u32 {
        self.child.id()
    }

    /// Ends it as `kill -9` does.
    pub fn kill(mut self) {
        self.child.kill().expect("the server can be killed");
        self.child.wait().expect("the server was started");
    }

    /// Asks for JSON below `/api/v1/`; answers the status and the body.
    #[must_use]
    pub fn get(&self, path: &str) -> (u16, Value) {
        let mut answer = agent().get(self.api(path)).call().expect("the server answers");
        (answer.status().as_u16(), answer.body_mut().read_json().unwrap_or(Value::Null))
    }

    /// Asks for bytes at a path; answers the status, the content type and the body.
    #[must_use]
    pub fn download(&self, path: &str) -> (u16, String, Vec<u8>) {
        let url = format!("{}{path}", self.url);
        let mut answer = agent().get(url).call().expect("the server answers");
        let kind = answer.headers().get("content-type").and_then(|kind| kind.to_str().ok());
        let kind = kind.unwrap_or_default().to_owned();
        let body = answer.body_mut().with_config().limit(100 << 20).read_to_vec();
        (answer.status().as_u16(), kind, body.expect("the whole body arrives"))
    }

    /// Posts JSON below `/api/v1/`; answers the status and the body.
    #[must_use]
    pub fn post(&self, path: &str, body: &Value) -> (u16, Value) {
        let mut answer = agent().post(self.api(path)).send_json(body).expect("the server answers");
        (answer.status().as_u16(), answer.body_mut().read_json().unwrap_or(Value::Null))
    }

    /// Posts any text below `/api/v1/`, said to be JSON.
    #[must_use]
    pub fn post_text(&self, path: &str, body: &str) -> (u16, Value) {
        let request = agent().post(self.api(path)).content_type("application/json");
        let mut answer = request.send(body).expect("the server answers");
        (answer.status().as_u16(), answer.body_mut().read_json().unwrap_or(Value::Null))
    }

    /// Deletes below `/api/v1/`; answers the status.
    #[must_use]
    pub fn delete(&self, path: &str) -> u16 {
        agent().delete(self.api(path)).call().expect("the server answers").status().as_u16()
    }

    /// Creates a session; answers its identifier.
    #[must_use]
    pub fn create(&self, body: &Value) -> String {
        let (status, session) = self.post("sessions", body);
        assert_eq!(status, 201, "{session}");
        session["id"].as_str().expect("a session has an id").to_owned()
    }

    /// Waits until a session satisfies a condition; answers it.
    #[must_use]
    pub fn wait(&self, id: &str, what: &str, reached: impl Fn(&Value) -> bool) -> Value {
        let start = Instant::now();
        loop {
            let (_, session) = self.get(&format!("sessions/{id}"));
            if reached(&session) {
                return session;
            }
            assert!(start.elapsed() < PATIENCE, "still not {what}: {session}");
            std::thread::sleep(Duration::from_millis(20));
        }
    }

    fn api(&self, path: &str) -> String {
        format!("{}/api/v1/{path}", self.url)
    }
}

impl Drop for Server {
    fn drop(&mut self) {
        // Already gone when a test killed it.
        let _ = self.child.kill();
        let _ = self.child.wait();
    }
}

/// Refusals are answers here, not errors.
fn agent() -> ureq::Agent {
    ureq::Agent::config_builder()
        .http_status_as_error(false)
        .timeout_global(Some(PATIENCE))
        .build()
        .into()
}

fn address_in(line: &str) -> Option<String> {
    let start = line.find("http://127.0.0.1:")?;
    let address = line[start..].split_whitespace().next()?;
    Some(address.trim_end_matches(['/', ',', '.']).to_owned())
}
