using System;

namespace Rabit.Links;

/// <summary>
/// A link could not be opened, read or written. The message is one line that names the link and the reason, fit for a
/// user.
/// </summary>
public sealed class LinkException : Exception
{
    /// <summary>Makes the error of one link.</summary>
    /// <param name="url">The link, see <see cref="IByteLink.Url"/>.</param>
    /// <param name="reason">What went wrong, one line without the URL.</param>
    /// <param name="linkEnded">See <see cref="LinkEnded"/>.</param>
    /// <param name="innerException">What the operating system or the runtime said, if anything.</param>
    /// <param name="mayPass">See <see cref="MayPass"/>.</param>
    public LinkException(
        string url, string reason, bool linkEnded, Exception? innerException = null, bool mayPass = false)
        : base($"link {url}: {reason}", innerException)
    {
        Url = url;
        Reason = reason;
        LinkEnded = linkEnded;
        MayPass = mayPass;
    }

    /// <summary>The link, see <see cref="IByteLink.Url"/>.</summary>
    public string Url { get; }

    /// <summary>What went wrong, one line without the URL.</summary>
    public string Reason { get; }

    /// <summary>
    /// True if the link is not usable any more or was never opened; false if only this write was lost and the next may
    /// succeed.
    /// </summary>
    public bool LinkEnded { get; }

    /// <summary>
    /// Whether a link that could not be opened may well be there later: a server that is not up yet, a device that is
    /// not plugged in. False for what a user must put right first: a missing permission, a port in use.
    /// </summary>
    public bool MayPass { get; }
}
