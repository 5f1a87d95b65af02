namespace Rabit.Mavlink;

/// <summary>How a transfer of a <see cref="MavlinkFtpClient"/> ended.</summary>
public enum MavlinkFtpStatus
{
    /// <summary>No outcome yet; never part of one.</summary>
    None,

    /// <summary>All of the file, or of the directory, is here.</summary>
    Done,

    /// <summary>There is no such file or directory.</summary>
    NotFound,

    /// <summary>It was refused for another reason: <see cref="MavlinkFtpOutcome.Error"/>.</summary>
    Refused,

    /// <summary>The file is larger than <see cref="MavlinkFtpClientOptions.MaxFileSize"/>.</summary>
    TooLarge,

    /// <summary>The checksum of what was read is not that of the file: it was changed meanwhile.</summary>
    WrongChecksum,

    /// <summary>No answer came, or none any more.</summary>
    Unanswered,

    /// <summary>It was cancelled from this side.</summary>
    Cancelled,
}
