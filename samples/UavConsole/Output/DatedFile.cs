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

        File.Move(path, FreeNameOf(path));
    }

    /// <summary>
    /// Copies a file aside and leaves it where it is, for one that stays valid until it is replaced; does nothing where
    /// there is none, or an empty one, nor to a device.
    /// </summary>
    public static void KeepCopy(string path)
    {
        if (OutputPath.IsOfDevice(path) || !File.Exists(path) || new FileInfo(path).Length == 0)
            return;

        // Of starts that came to nothing one copy is enough.
        string dated = NameOf(path, number: 1);
        if (!File.Exists(dated) || !File.ReadAllBytes(dated).AsSpan().SequenceEqual(File.ReadAllBytes(path)))
            File.Copy(path, FreeNameOf(path));
    }

    private static string FreeNameOf(string path)
    {
        int number = 1;
        while (File.Exists(NameOf(path, number)))
            number++;
        return NameOf(path, number);
    }

    private static string NameOf(string path, int number)
    {
        string date = File.GetLastWriteTimeUtc(path).ToString("yyyyMMdd-HHmmss", CultureInfo.InvariantCulture);
        string name = Path.Combine(
            Path.GetDirectoryName(Path.GetFullPath(path))!, Path.GetFileNameWithoutExtension(path) + "." + date);
        string suffix = number == 1 ? string.Empty : FormattableString.Invariant($"-{number}");
        return name + suffix + Path.GetExtension(path);
    }
}
