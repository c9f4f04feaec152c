//! Access to the server: the token, and the headers that protect it from pages of other origins.
//!
//! - The token is part of the printed address. The first page load stores it in a cookie that
//!   scripts cannot read and that other sites do not send, and redirects to an address without it.
//!   Programs send it as `Authorization: Bearer TOKEN`.
//! - `Host` must name the address listened on. A foreign domain that resolves to this machine (DNS
//!   rebinding) is refused, because it cannot make a browser send another `Host`.
//! - `Origin`, if sent, must be that of the page. `Sec-Fetch-Site`, if sent, must be `same-origin`
//!   or `none`; only the page itself may be opened from elsewhere, and then needs the token.

use super::Studio;
use super::error::RequestError;
use axum::body::Body;
use axum::extract::{Request, State};
use axum::http::header::{self, HeaderMap, HeaderName, HeaderValue};
use axum::http::{StatusCode, Uri};
use axum::middleware::Next;
use axum::response::{IntoResponse, Response};
use sha2::{Digest, Sha256};
use std::fmt::Write;
use std::net::{IpAddr, SocketAddr};
use std::sync::Arc;

/// Number of random bytes of the token.
const TOKEN_BYTES: usize = 24;

/// Headers of all responses: nothing is loaded from elsewhere, framed, stored or guessed.
const HEADERS: [(HeaderName, &str); 5] = [
    (
        header::CONTENT_SECURITY_POLICY,
        "default-src 'none'; script-src 'self' 'wasm-unsafe-eval'; style-src 'self' 'unsafe-inline'; \
         img-src 'self' data: blob:; connect-src 'self' data: blob:; worker-src 'self' blob:; base-uri 'none'; \
         form-action 'none'; frame-ancestors 'none'",
    ),
    (header::X_CONTENT_TYPE_OPTIONS, "nosniff"),
    (header::REFERRER_POLICY, "no-referrer"),
    (header::CACHE_CONTROL, "no-store"),
    (HeaderName::from_static("cross-origin-resource-policy"), "same-origin"),
];

/// The token and the accepted hosts of a server.
pub(crate) struct Access {
    token: String,
    address: SocketAddr,
    /// Host name or address that the user listens on.
    listen: String,
}

impl Access {
    /// Creates the access with a new random token.
    ///
    /// # Errors
    /// The operating system provides no random numbers.
    pub fn new(listen: &str, address: SocketAddr) -> Result<Access, getrandom::Error> {
        let mut bytes = [0_u8; TOKEN_BYTES];
        getrandom::fill(&mut bytes)?;
        let token = bytes.iter().fold(String::new(), |mut text, byte| {
            let _ = write!(text, "{byte:02x}");
            text
        });
        Ok(Access { token, address, listen: listen.to_ascii_lowercase() })
    }

    /// Returns the address to open, with the token.
    pub fn url(&self) -> String {
        let port = self.address.port();
        let host = match self.address.ip() {
            ip if ip.is_unspecified() => "localhost".to_owned(),
            IpAddr::V6(ip) => format!("[{ip}]"),
            IpAddr::V4(ip) => ip.to_string(),
        };
        format!("http://{host}:{port}/?token={}", self.token)
    }

    /// Cookies do not depend on the port, so its name does.
    fn cookie(&self) -> String {
        format!("calyx_studio_{}", self.address.port())
    }

    /// Returns true if a browser that opened the page sends this `Host`.
    fn is_host(&self, host: &str) -> bool {
        let port = self.address.port();
        let name = match host.rsplit_once(':') {
            Some((name, text)) if text.parse() == Ok(port) => name,
            // Browsers omit the standard port.
            _ if port == 80 => host,
            _ => return false,
        };
        let (name, here) = (name.to_ascii_lowercase(), self.address.ip());
        let literal = name.strip_prefix('[').and_then(|name| name.strip_suffix(']')).unwrap_or(&name);
        match literal.parse::<IpAddr>() {
            // A rebound domain is a name, so every address of this machine is safe.
            Ok(ip) => ip == here || here.is_unspecified() || (here.is_loopback() && ip.is_loopback()),
            Err(_) => {
                name == self.listen || (name == "localhost" && (here.is_loopback() || here.is_unspecified()))
            }
        }
    }

    /// Compares hashes, whose comparison reveals nothing about the token by its duration.
    fn is_token(&self, text: &str) -> bool {
        Sha256::digest(text.as_bytes()) == Sha256::digest(self.token.as_bytes())
    }

    /// Returns true if the request has the token in a header or in the cookie.
    fn is_authorized(&self, headers: &HeaderMap) -> bool {
        let bearer = headers.get(header::AUTHORIZATION).and_then(|value| value.to_str().ok());
        if let Some(token) = bearer.and_then(|value| value.strip_prefix("Bearer ")) {
            return self.is_token(token.trim());
        }
        let name = self.cookie();
        let cookies = headers.get_all(header::COOKIE).iter().filter_map(|value| value.to_str().ok());
        let mut pairs =
            cookies.flat_map(|line| line.split(';')).filter_map(|pair| pair.trim().split_once('='));
        pairs.any(|(key, value)| key == name && self.is_token(value))
    }

    /// Refuses requests that do not come from the page itself or from a program of the user.
    fn refuse_foreign(&self, uri: &Uri, headers: &HeaderMap, is_page: bool) -> Result<(), RequestError> {
        let refused = |message: &str| {
            let help = "open the address that `calyx studio` printed";
            Err(RequestError::new(StatusCode::FORBIDDEN, message, help))
        };
        let mut hosts = headers.get_all(header::HOST).iter();
        let host = match (hosts.next().and_then(|host| host.to_str().ok()), hosts.next()) {
            (Some(host), None) if self.is_host(host) => host,
            _ => return refused("the host of this request is not the address of the studio"),
        };
        if uri.authority().is_some_and(|authority| !self.is_host(authority.as_str())) {
            return refused("the host of this request is not the address of the studio");
        }
        let own = format!("http://{host}");
        if headers.get_all(header::ORIGIN).iter().any(|origin| origin.as_bytes() != own.as_bytes()) {
            return refused("requests of other sites are refused");
        }
        let site = headers.get("sec-fetch-site").map(HeaderValue::as_bytes);
        match site {
            None | Some(b"same-origin" | b"none") => Ok(()),
            Some(_) if is_page => Ok(()),
            Some(_) => refused("requests of other sites are refused"),
        }
    }
}

/// Checks the access of a request, and adds the headers of all responses.
pub(crate) async fn guard(State(studio): State<Arc<Studio>>, request: Request, next: Next) -> Response {
    let access = &studio.access;
    let is_page = request.uri().path() == "/";
    let mut response = match access.refuse_foreign(request.uri(), request.headers(), is_page) {
        Err(refused) => refused.into_response(),
        Ok(()) => match token_of(request.uri()).filter(|_| is_page) {
            Some(token) if access.is_token(token) => welcome(access),
            Some(_) => unauthorized(is_page),
            None if access.is_authorized(request.headers()) => readable(next.run(request).await),
            None => unauthorized(is_page),
        },
    };
    for (name, value) in HEADERS {
        // The report of a run has a stricter policy of its own.
        response.headers_mut().entry(name).or_insert(HeaderValue::from_static(value));
    }
    response
}

/// Returns the token in the query of an address.
fn token_of(uri: &Uri) -> Option<&str> {
    uri.query()?.split('&').find_map(|pair| pair.strip_prefix("token="))
}

/// Stores the token in a cookie, and redirects to the address without it, so that neither the
/// history nor a bookmark contains the token.
fn welcome(access: &Access) -> Response {
    let cookie = format!("{}={}; HttpOnly; SameSite=Strict; Path=/", access.cookie(), access.token);
    let headers = [(header::SET_COOKIE, cookie), (header::LOCATION, "/".to_owned())];
    (StatusCode::SEE_OTHER, headers).into_response()
}

fn unauthorized(is_page: bool) -> Response {
    let message = "this request has no valid token";
    let help = "open the address that `calyx studio` printed: it ends in a token";
    if is_page {
        let text = format!("Calyx studio: {message}.\n{help}\n");
        return (StatusCode::UNAUTHORIZED, text).into_response();
    }
    RequestError::new(StatusCode::UNAUTHORIZED, message, help).into_response()
}

/// Replaces error texts of the HTTP library by errors in JSON.
fn readable(response: Response) -> Response {
    let status = response.status();
    let is_json = response.headers().get(header::CONTENT_TYPE).is_some_and(|kind| kind == "application/json");
    if !(status.is_client_error() || status.is_server_error()) || is_json {
        return response;
    }
    let message = match status {
        StatusCode::NOT_FOUND => "there is nothing at this address",
        StatusCode::METHOD_NOT_ALLOWED => "this address does not support this method",
        StatusCode::PAYLOAD_TOO_LARGE => "the request is too large",
        _ => "the request is malformed",
    };
    let mut replaced = RequestError::new(status, message, "").into_response();
    if let Some(allow) = response.headers().get(header::ALLOW) {
        replaced.headers_mut().insert(header::ALLOW, allow.clone());
    }
    drop::<Body>(response.into_body());
    replaced
}

#[cfg(test)]
mod tests {
    use super::*;

    fn accepted(listen: &str, address: &str, hosts: &[&str]) -> Vec<bool> {
        let access = Access::new(listen, address.parse().expect("an address")).expect("random numbers");
        hosts.iter().map(|host| access.is_host(host)).collect()
    }

    #[test]
    fn only_hosts_of_the_address_listened_on_are_accepted() {
        let hosts = [
            "127.0.0.1:8000",
            "localhost:8000",
            "[::1]:8000",
            "evil.example:8000",
            "127.0.0.1:8001",
            "127.0.0.1",
            "192.168.0.7:8000",
            "",
        ];
        assert_eq!(
            accepted("127.0.0.1", "127.0.0.1:8000", &hosts),
            [true, true, true, false, false, false, false, false]
        );
        assert_eq!(
            accepted("0.0.0.0", "0.0.0.0:8000", &hosts),
            [true, true, true, false, false, false, true, false]
        );
        let named = ["desk.example:8000", "DESK.example:8000", "localhost:8000", "192.168.0.7:8000"];
        assert_eq!(accepted("desk.example", "192.168.0.7:8000", &named), [true, true, false, true]);
    }
}
