using System;
using System.IO;
using System.Linq;
using System.Security.Cryptography;
using System.Text;

namespace Rabit.Uav.Web;

/// <summary>
/// What a browser must know to command a vehicle. Only its hash is kept, and no text that comes of it says anything of
/// it. Immutable.
/// </summary>
/// <example>
/// <code>
/// var options = new LivePageOptions { Token = LivePageToken.ReadFile("/etc/rabit/page-token") };
/// </code>
/// </example>
public sealed class LivePageToken
{
    /// <summary>A token has at least so many characters.</summary>
    public const int MinLength = 16;

    /// <summary>A token has at most so many characters.</summary>
    public const int MaxLength = 256;

    private readonly byte[] _hash;

    private LivePageToken(byte[] hash) => _hash = hash;

    /// <summary>Reads a token: the first line of a file, as <c>openssl rand -hex 16</c> writes it.</summary>
    /// <param name="path">The file.</param>
    /// <exception cref="ArgumentException">
    /// The file cannot be read, holds no token, or others than its owner and group may read it; the text names the file
    /// and says why.
    /// </exception>
    public static LivePageToken ReadFile(string path)
    {
        try
        {
            if (!OperatingSystem.IsWindows() && (File.GetUnixFileMode(path) & UnixFileMode.OtherRead) != 0)
                throw new ArgumentException(
                    $"Token {path}: every user of this computer may read it; chmod 640 takes that away.", nameof(path));
            using var reader = new StreamReader(path);
            var text = new char[MaxLength + 2];
            int length = reader.ReadBlock(text, 0, text.Length);
            int end = Array.FindIndex(text, 0, length, c => c is '\r' or '\n');
            var token = new string(text, 0, end < 0 ? length : end);
            Array.Clear(text);
            return FindFault(token) is { } fault
                ? throw new ArgumentException($"Token {path}: {fault}", nameof(path))
                : Create(token);
        }
        catch (Exception e) when (e is IOException or UnauthorizedAccessException or NotSupportedException)
        {
            throw new ArgumentException($"Token {path}: {e.Message}", nameof(path), e);
        }
    }

    /// <summary>Makes a token of a text.</summary>
    /// <param name="token">16 to 256 printable ASCII characters, without blanks.</param>
    /// <exception cref="ArgumentException">It is none of that kind.</exception>
    public static LivePageToken Create(string token)
    {
        ArgumentNullException.ThrowIfNull(token);
        return FindFault(token) is { } fault
            ? throw new ArgumentException("The token of the live page: " + fault, nameof(token))
            : new LivePageToken(SHA256.HashData(Encoding.ASCII.GetBytes(token)));
    }

    /// <summary>Says that it is one, and nothing more.</summary>
    public override string ToString() => "token";

    /// <summary>Whether it is this one. It takes as long for one that is nearly right as for any other.</summary>
    internal bool IsEqual(ReadOnlySpan<char> given)
    {
        Span<byte> bytes = stackalloc byte[MaxLength];
        bool isShort = given.Length <= MaxLength;
        int length = isShort ? Encoding.UTF8.GetByteCount(given) : 0;
        isShort &= length is > 0 and <= MaxLength;
        if (isShort)
            Encoding.UTF8.GetBytes(given, bytes);
        Span<byte> hash = stackalloc byte[SHA256.HashSizeInBytes];
        SHA256.HashData(bytes[..(isShort ? length : 0)], hash);
        return CryptographicOperations.FixedTimeEquals(hash, _hash);
    }

    private static string? FindFault(string token)
        => token.Length is < MinLength or > MaxLength
            ? $"it has {token.Length} characters; {MinLength} to {MaxLength} are needed."
            : token.Any(c => c is <= ' ' or > '~')
                ? "it may have printable ASCII characters only, and no blanks."
                : null;
}
