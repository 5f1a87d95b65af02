using System;
using System.IO;
using Rabit.Vision;

namespace VisionBench;

/// <summary>Pictures as addresses that need no network.</summary>
internal static class PictureUri
{
    /// <summary>The file as it is, where browsers know its kind; else as PNG.</summary>
    /// <exception cref="IOException">It cannot be read.</exception>
    /// <exception cref="PictureException">It is no picture.</exception>
    public static string Of(string path)
    {
        byte[] file = File.ReadAllBytes(path);
        string? kind = file.Length < 4 ? null
            : file[0] == 0xFF && file[1] == 0xD8 ? "jpeg"
            : file[0] == 0x89 && file[1] == 'P' && file[2] == 'N' && file[3] == 'G' ? "png"
            : null;
        if (kind is null)
            (kind, file) = ("png", PngPicture.Encode(new PictureReader().Load(path)));
        return $"data:image/{kind};base64,{Convert.ToBase64String(file)}";
    }
}
