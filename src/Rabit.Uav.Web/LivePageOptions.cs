using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using System.Net;

namespace Rabit.Uav.Web;

/// <summary>Where a <see cref="LivePage"/> is, and who may command by it. Read once, when it is made.</summary>
public sealed class LivePageOptions
{
    /// <summary>The port without a choice.</summary>
    public const int DefaultPort = 8080;

    /// <summary>
    /// The address and the port to listen at; port 0 takes a free one. Another address than loopback needs
    /// <see cref="Token"/>.
    /// </summary>
    /// <value>The default is 127.0.0.1, <see cref="DefaultPort"/>.</value>
    public IPEndPoint EndPoint { get; set; } = new(IPAddress.Loopback, DefaultPort);

    /// <summary>What a browser must know to command; null where none may.</summary>
    /// <value>The default is null.</value>
    public LivePageToken? Token { get; set; }

    /// <summary>
    /// Names by which browsers may reach the page, beside the name of this computer, <c>localhost</c> and addresses:
    /// any other name is refused, so that no foreign page can pass its own name off as ours.
    /// </summary>
    /// <value>The default is none.</value>
    public IReadOnlyList<string> HostNames { get; set; } = [];

    /// <summary>
    /// A folder of map tiles, <c>ZOOM/X/Y.png</c> as tile servers name them, drawn below the map; null for none.
    /// </summary>
    /// <value>The default is null.</value>
    public string? TileFolder { get; set; }

    /// <summary>How many browsers may watch at once, 1 to 200.</summary>
    /// <value>The default is 32.</value>
    public int MaxBrowsers { get; set; } = 32;

    internal void Validate(string parameter)
    {
        string[] faults = [.. FindFaults()];
        if (faults.Length > 0)
            throw new ArgumentException(string.Join(" ", faults), parameter);
    }

    internal LivePageOptions Copy() => (LivePageOptions)MemberwiseClone();

    private IEnumerable<string> FindFaults()
    {
        if (EndPoint is null)
            yield return "EndPoint: there is none.";
        else if (!IPAddress.IsLoopback(EndPoint.Address) && Token is null)
            yield return $"EndPoint: {EndPoint} can be reached from other computers, which needs a Token.";
        if (MaxBrowsers is < 1 or > 200)
            yield return $"MaxBrowsers: it is {MaxBrowsers}; it must be 1 to 200.";
        if (HostNames is null || HostNames.Any(string.IsNullOrWhiteSpace))
            yield return "HostNames: each must be a name.";
        if (TileFolder is { } folder && !Directory.Exists(folder))
            yield return $"TileFolder: there is no folder {folder}.";
    }
}
