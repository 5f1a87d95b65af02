namespace Rabit.Mavlink.Protocols;

/// <summary>The reason in the first byte of a NAK.</summary>
internal enum FtpError : byte
{
    None = 0,
    Fail = 1,
    FailErrno = 2,
    InvalidDataSize = 3,
    InvalidSession = 4,
    NoSessionsAvailable = 5,
    EndOfFile = 6,
    UnknownCommand = 7,
    FileExists = 8,
    FileProtected = 9,
    FileNotFound = 10,
}
