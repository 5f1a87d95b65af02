using System;
using System.IO;
using Rabit.Mavlink;

namespace Rabit.Uav.Communications;

/// <summary>Reads a signing key from a file. No text that comes of it has anything of the key.</summary>
public static class SigningKeyFile
{
    private const int HexLength = 2 * MavlinkSigningKey.Length;

    // A key file is a line; a film that is named by mistake is not read to its end.
    private const int MaxFileLength = 4096;

    /// <summary>
    /// Reads a key: 32 bytes, or a text that begins with its 64 hexadecimal digits, as <c>sha256sum</c> writes it.
    /// </summary>
    /// <param name="path">The file.</param>
    /// <returns>The key; the caller disposes of it.</returns>
    /// <exception cref="ArgumentException">
    /// The file cannot be read, or holds no key; the text names the file and says why.
    /// </exception>
    public static MavlinkSigningKey Read(string path)
    {
        byte[] content = ReadBytes(path);
        byte[]? secret = content.Length == MavlinkSigningKey.Length ? content : FromHex(content);
        try
        {
            if (secret is null)
                throw new ArgumentException(
                    $"Signing key {path}: it holds neither {MavlinkSigningKey.Length} bytes nor {HexLength} "
                        + "hexadecimal digits.",
                    nameof(path));
            if (Array.TrueForAll(secret, b => b == 0))
                throw new ArgumentException($"Signing key {path}: a key of zeros is no key.", nameof(path));
            return new MavlinkSigningKey(secret);
        }
        finally
        {
            Array.Clear(content, 0, content.Length);
            Array.Clear(secret ?? [], 0, secret?.Length ?? 0);
        }
    }

    private static byte[] ReadBytes(string path)
    {
        try
        {
            using var file = new FileStream(path, FileMode.Open, FileAccess.Read);
            if (file.Length > MaxFileLength)
                throw new ArgumentException($"Signing key {path}: {file.Length} bytes are no key.", nameof(path));
            var content = new byte[file.Length];
            int count = 0;
            for (int read = 1; read > 0 && count < content.Length; count += read)
                read = file.Read(content, count, content.Length - count);
            return content;
        }
        catch (Exception e) when (e is IOException or UnauthorizedAccessException or NotSupportedException)
        {
            throw new ArgumentException($"Signing key {path}: {e.Message}", nameof(path), e);
        }
    }

    private static byte[]? FromHex(byte[] text)
    {
        bool isText = text.Length >= HexLength
            && (text.Length == HexLength || text[HexLength] is (byte)' ' or (byte)'\r' or (byte)'\n' or (byte)'\t');
        if (!isText)
            return null;
        var secret = new byte[MavlinkSigningKey.Length];
        for (int digit = 0; digit < HexLength; digit++)
        {
            int value = ValueOf(text[digit]);
            if (value < 0)
            {
                Array.Clear(secret, 0, secret.Length);
                return null;
            }

            secret[digit / 2] = (byte)((secret[digit / 2] << 4) | value);
        }

        return secret;
    }

    private static int ValueOf(byte digit) => digit switch
    {
        >= (byte)'0' and <= (byte)'9' => digit - '0',
        >= (byte)'a' and <= (byte)'f' => digit - 'a' + 10,
        >= (byte)'A' and <= (byte)'F' => digit - 'A' + 10,
        _ => -1,
    };
}
