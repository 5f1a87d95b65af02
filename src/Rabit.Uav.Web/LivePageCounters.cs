namespace Rabit.Uav.Web;

/// <summary>
/// What a <see cref="LivePage"/> has done and refused so far. A plain value; counts are since the start.
/// </summary>
public struct LivePageCounters
{
    /// <summary>Browsers that watch now.</summary>
    public int Browsers { get; set; }

    /// <summary>Browsers that were refused because too many watched.</summary>
    public long BrowsersRefused { get; set; }

    /// <summary>Browsers that took no message for ten seconds, or sent something, and were cut off.</summary>
    public long BrowsersDropped { get; set; }

    /// <summary>Messages to browsers.</summary>
    public long Messages { get; set; }

    /// <summary>Bytes of these messages.</summary>
    public long MessageBytes { get; set; }

    /// <summary>The longest of these messages, bytes.</summary>
    public int MaxMessageBytes { get; set; }

    /// <summary>Connections that were closed because too many were open.</summary>
    public long ConnectionsRefused { get; set; }

    /// <summary>Connections that ended without a request that could be read: half-open, or malformed.</summary>
    public long ConnectionsWithoutRequest { get; set; }

    /// <summary>Requests that were refused: by their host or origin, too large, or for what is not there.</summary>
    public long RequestsRefused { get; set; }

    /// <summary>Commands that Mission Control was given.</summary>
    public long Commands { get; set; }

    /// <summary>Commands that were refused: without the token, too many a second, or malformed.</summary>
    public long CommandsRefused { get; set; }

    /// <summary>Moments of the flight that the page had no time to take.</summary>
    public long MomentsDropped { get; set; }

    /// <summary>Faults of the page itself; it went on after them.</summary>
    public long Faults { get; set; }
}
