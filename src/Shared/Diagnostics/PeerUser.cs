using System;
using System.Net.Sockets;
using System.Runtime.InteropServices;

namespace Rabit.Diagnostics.Protocol;

/// <summary>Users of processes on Linux: our own, and that of the process at the other end of a Unix socket.</summary>
internal static class PeerUser
{
    public const uint Root = 0;

    private const int SocketLevel = 1;       // SOL_SOCKET
    private const int PeerCredentials = 17;  // SO_PEERCRED: struct ucred { pid_t pid; uid_t uid; gid_t gid; }
    private const int CredentialsLength = 12;
    private const int UserOffset = 4;

    /// <summary>The user by whose rights this process works.</summary>
    public static uint Own => GetEffectiveUser();

    /// <summary>Who connected, or who listened, when the connection was made, as the kernel has it.</summary>
    /// <exception cref="SocketException">The system does not know.</exception>
    public static uint Of(Socket socket)
    {
        Span<byte> credentials = stackalloc byte[CredentialsLength];
        int length = socket.GetRawSocketOption(SocketLevel, PeerCredentials, credentials);
        return length == CredentialsLength
            ? MemoryMarshal.Read<uint>(credentials[UserOffset..])
            : throw new SocketException((int)SocketError.OperationNotSupported);
    }

    [DllImport("libc", EntryPoint = "geteuid")]
    [DefaultDllImportSearchPaths(DllImportSearchPath.SafeDirectories)]
    private static extern uint GetEffectiveUser();
}
