using System;
using System.Globalization;
using System.IO;
using System.Linq;
using System.Net.Sockets;
using System.Runtime.Versioning;
using Rabit.Diagnostics.Protocol;

namespace Rabit.Diagnostics.Sockets;

/// <summary>The socket that a program listens on: in a folder of mode 0700, itself of mode 0600.</summary>
internal sealed class DiagnosticsSocket : IDisposable
{
    private const int MaxNameLength = 40;

    // A few programs of one process, each with a reactor; more of them are a mistake.
    private const int MaxOfOneProcess = 16;
    private const int Backlog = 4;
    private const UnixFileMode OwnFolder = UnixFileMode.UserRead | UnixFileMode.UserWrite | UnixFileMode.UserExecute;
    private const UnixFileMode OwnSocket = UnixFileMode.UserRead | UnixFileMode.UserWrite;

    private DiagnosticsSocket(Socket listener, string program, string path)
    {
        Listener = listener;
        Program = program;
        Path = path;
    }

    public Socket Listener { get; }

    /// <summary>The name under which tools find it.</summary>
    public string Program { get; }

    public string Path { get; }

    /// <exception cref="IOException">
    /// The folder is not ours, or the socket cannot be made; the text says which.
    /// </exception>
    [SupportedOSPlatform("linux")]
    public static DiagnosticsSocket Open(string program, string? folder)
    {
        folder ??= DiagnosticsFolder.OfSession(Environment.GetEnvironmentVariable(DiagnosticsFolder.Variable))
            ?? DiagnosticsFolder.WithoutSession(PeerUser.Own);
        Prepare(folder);
        RemoveStale(folder);
        string name = NameOf(program);
        for (int number = 1; number <= MaxOfOneProcess; number++)
        {
            string numbered = number == 1 ? name : FormattableString.Invariant($"{name}.{number}");
            string path = System.IO.Path.Combine(
                folder, DiagnosticsFolder.FileOf(numbered, Environment.ProcessId));
            if (TryListen(path) is { } listener)
                return new DiagnosticsSocket(listener, numbered, path);
        }

        throw new IOException($"This process has {MaxOfOneProcess} sockets of '{name}' in {folder} already.");
    }

    public void Dispose()
    {
        Listener.Dispose();
        Delete(Path);
    }

    private static string NameOf(string program)
    {
        char[] name = program.Take(MaxNameLength)
            .Select(c => char.IsAsciiLetterOrDigit(c) || c is '.' or '-' or '_' ? c : '_').ToArray();
        return name.Length == 0 || name[0] == '.' ? "_" + new string(name) : new string(name);
    }

    [SupportedOSPlatform("linux")]
    private static void Prepare(string folder)
    {
        string parent = System.IO.Path.GetDirectoryName(System.IO.Path.GetFullPath(folder)) ?? "/";
        if (!Directory.Exists(parent))
            throw new IOException(
                $"there is no folder {parent} (it comes from {DiagnosticsFolder.Variable}, or from the options).");
        Directory.CreateDirectory(folder, OwnFolder);
        if (!FolderOwner.IsFolderOf(folder, PeerUser.Own))
            throw new IOException($"{folder} is not a folder of this user.");
        File.SetUnixFileMode(folder, OwnFolder);   // the umask, or one who made it before
    }

    // Where none listens, because the process ended without a word: no other process of this name and number will come.
    private static void RemoveStale(string folder)
    {
        foreach ((string path, _, int processId) in DiagnosticsFolder.Find(folder).ToArray())
        {
            bool isAlive = Directory.Exists("/proc/" + processId.ToString(CultureInfo.InvariantCulture));
            if (!isAlive && !Listens(path))
                Delete(path);
        }
    }

    /// <returns>Null where another of this process listens there.</returns>
    [SupportedOSPlatform("linux")]
    private static Socket? TryListen(string path)
    {
        if (File.Exists(path))
        {
            // Of this process, or of one that had its number before.
            if (Listens(path))
                return null;
            Delete(path);
        }

        var listener = new Socket(AddressFamily.Unix, SocketType.Stream, ProtocolType.Unspecified);
        try
        {
            // None can connect before it listens, and so none while its mode is not yet right.
            listener.Bind(EndPointOf(path));
            File.SetUnixFileMode(path, OwnSocket);
            listener.Listen(Backlog);
            return listener;
        }
        catch
        {
            listener.Dispose();
            throw;
        }
    }

    private static bool Listens(string path)
    {
        using var probe = new Socket(AddressFamily.Unix, SocketType.Stream, ProtocolType.Unspecified);
        probe.Blocking = false;
        try
        {
            probe.Connect(EndPointOf(path));
            return true;
        }
        catch (SocketException e)
        {
            // Full is alive too.
            return e.SocketErrorCode is SocketError.WouldBlock or SocketError.InProgress;
        }
    }

    private static UnixDomainSocketEndPoint EndPointOf(string path)
    {
        try
        {
            return new UnixDomainSocketEndPoint(path);
        }
        catch (ArgumentException e)
        {
            // The system has room for some 107 bytes.
            throw new IOException($"the path of the socket is too long: {path}", e);
        }
    }

    private static void Delete(string path)
    {
        try
        {
            File.Delete(path);
        }
        catch (Exception e) when (e is IOException or UnauthorizedAccessException)
        {
            // It stays, and tools see that none listens.
        }
    }
}
