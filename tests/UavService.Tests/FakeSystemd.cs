using System;
using System.Collections.Generic;
using System.IO;
using System.Net.Sockets;
using System.Text;
using Rabit.Tests.Shared;

namespace UavService.Tests;

/// <summary>The service manager's end of the notification protocol, in the file system or abstract.</summary>
internal sealed class FakeSystemd : IDisposable
{
    private static readonly TimeSpan MaxWait = TimeSpan.FromSeconds(120);   // on an idle machine

    private readonly Socket _socket = new(AddressFamily.Unix, SocketType.Dgram, ProtocolType.Unspecified);
    private readonly byte[] _buffer = new byte[4096];
    private readonly string? _file;

    public FakeSystemd(bool isAbstract)
    {
        string name = "uav-service-" + Guid.NewGuid().ToString("N");
        _file = isAbstract ? null : Path.Combine(Path.GetTempPath(), name);
        Address = _file ?? "@" + name;
        _socket.Bind(new UnixDomainSocketEndPoint(_file ?? "\0" + name));
    }

    /// <summary>For NOTIFY_SOCKET.</summary>
    public string Address { get; }

    /// <summary>All notifications so far.</summary>
    public List<string> All { get; } = [];

    /// <summary>The next notification that holds a text; those before it are in <see cref="All"/>.</summary>
    public string WaitFor(string text)
    {
        while (_socket.Poll(TestTimeout.LimitOf(MaxWait), SelectMode.SelectRead))
        {
            All.Add(Encoding.UTF8.GetString(_buffer, 0, _socket.Receive(_buffer)));
            if (All[^1].Contains(text, StringComparison.Ordinal))
                return All[^1];
        }

        throw new TimeoutException($"No '{text}' but: {string.Join(" | ", All)}");
    }

    public void Dispose()
    {
        _socket.Dispose();
        if (_file is not null)
            File.Delete(_file);
    }
}
