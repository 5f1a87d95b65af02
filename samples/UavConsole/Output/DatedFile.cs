using System;
using System.Globalization;
using System.IO;

namespace UavConsole;

/// <summary>Keeps the file of an earlier run beside the new one: NAME.20261122-143000.EXT, by its change.</summary>
internal static class DatedFile
{
    /// <summary>Moves a file aside, an empty one away; does nothing where there is none, nor to a device.</summary>
    public static void Keep(string path)
    {
        if (!File.Exists(path) || OutputPath.IsOfDevice(path))
            return;
        if (new FileInfo(path).Length == 0)
        {
            File.Delete(path);
            return;
        }

        string date = File.GetLastWriteTimeUtc(path).ToString("yyyyMMdd-HHmmss", CultureInfo.InvariantCulture);
        string name = Path.Combine(
            Path.GetDirectoryName(Path.GetFullPath(path))!, Path.GetFileNameWithoutExtension(path) + "." + date);
        string extension = Path.GetExtension(path);
        string kept = name + extension;
        for (int number = 2; File.Exists(kept); number++)
            kept = FormattableString.Invariant($"{name}-{number}{extension}");
        File.Move(path, kept);
    }
}
