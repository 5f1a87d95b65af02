using System;
using System.Collections.Generic;
using System.Linq;

namespace Rabit.Mavlink.Generator.Reading;

/// <summary>
/// Finds an included file among the given ones: beside the including file first, then by its bare name wherever it is.
/// </summary>
internal static class IncludePath
{
    public static DialectFile? Find(IReadOnlyList<DialectFile> files, string from, string include)
    {
        string folder = Normalize(from);
        folder = folder.Substring(0, folder.LastIndexOf('/') + 1);
        string wanted = Normalize(folder + include.Replace('\\', '/'));
        return files.FirstOrDefault(file => Same(file.Path, wanted))
            ?? files.FirstOrDefault(
                file => string.Equals(FileName(file.Path), FileName(include), StringComparison.OrdinalIgnoreCase));
    }

    // Windows and macOS do not distinguish case in names, and no two definition files differ only in case.
    public static bool Same(string left, string right)
        => string.Equals(Normalize(left), Normalize(right), StringComparison.OrdinalIgnoreCase);

    public static string FileName(string path) => path.Substring(path.Replace('\\', '/').LastIndexOf('/') + 1);

    public static string Normalize(string path)
    {
        var parts = new List<string>();
        foreach (string part in path.Replace('\\', '/').Split('/'))
        {
            if (part == ".." && parts.Count > 0 && parts[parts.Count - 1] is not (".." or ""))
                parts.RemoveAt(parts.Count - 1);
            else if (part != ".")
                parts.Add(part);
        }

        return string.Join("/", parts);
    }
}
