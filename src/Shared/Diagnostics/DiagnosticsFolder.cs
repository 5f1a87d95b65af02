using System;
using System.Collections.Generic;
using System.Globalization;
using System.IO;
using System.Linq;

namespace Rabit.Diagnostics.Protocol;

/// <summary>Where programs put their sockets and the tool looks for them.</summary>
internal static class DiagnosticsFolder
{
    public const string Variable = "XDG_RUNTIME_DIR";
    public const string Extension = ".sock";

    private const string Name = "rabit";

    /// <summary>The folder of the user's session; null where there is no session.</summary>
    public static string? OfSession(string? runtimeDirectory)
        => string.IsNullOrEmpty(runtimeDirectory) || !Path.IsPathRooted(runtimeDirectory)
            ? null
            : Path.Combine(runtimeDirectory, Name);

    /// <summary>The folder for programs without a session, as one that is started by cron or at boot.</summary>
    public static string WithoutSession(uint user) => FormattableString.Invariant($"/tmp/{Name}-{user}");

    /// <summary>The name of a socket's file.</summary>
    public static string FileOf(string program, int processId)
        => FormattableString.Invariant($"{program}-{processId}{Extension}");

    /// <summary>The sockets in a folder, with what their names say.</summary>
    public static IEnumerable<(string Path, string Program, int ProcessId)> Find(string folder)
    {
        if (!Directory.Exists(folder))
            return [];
        return Directory.EnumerateFiles(folder, "*" + Extension).Select(Parse).Where(f => f.ProcessId > 0);
    }

    private static (string Path, string Program, int ProcessId) Parse(string path)
    {
        string name = Path.GetFileNameWithoutExtension(path);
        int dash = name.LastIndexOf('-');
        return dash > 0
            && int.TryParse(name.AsSpan(dash + 1), NumberStyles.None, CultureInfo.InvariantCulture, out int processId)
            ? (path, name[..dash], processId)
            : (path, name, 0);
    }
}
