using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using System.Net.Sockets;
using System.Text;
using Microsoft.Extensions.DependencyInjection;
using Rabit.Tests.Shared;
using Xunit;

namespace Rabit.Hosting.Tests;

/// <summary>The service manager's end of the notification protocol, in the file system or abstract.</summary>
internal sealed class FakeSystemd : IDisposable
{
    private readonly Socket _socket = new(AddressFamily.Unix, SocketType.Dgram, ProtocolType.Unspecified);
    private readonly byte[] _buffer = new byte[4096];
    private readonly string? _file;

    public FakeSystemd(bool isAbstract)
    {
        string name = "rabit-notify-" + Guid.NewGuid().ToString("N");
        _file = isAbstract ? null : Path.Combine(Path.GetTempPath(), name);
        Address = _file ?? "@" + name;
        _socket.Bind(new UnixDatagramEndPoint(Address));
    }

    public string Address { get; }

    public Dictionary<string, string> Environment { get; } = new(StringComparer.Ordinal);

    public IServiceCollection AddTo(IServiceCollection services, int processId = 1)
    {
        Environment["NOTIFY_SOCKET"] = Address;
        services.AddSingleton(new SystemdEnvironment(
            n => Environment.TryGetValue(n, out string? value) ? value : null, processId));
        return services.AddRabitSystemd();
    }

    /// <summary>The next notification; null when none comes.</summary>
    public string? Next() => Next(TestTimeout.Limit.TotalSeconds);

    /// <summary>The next notification; null when none comes in the time.</summary>
    public string? Next(double seconds)
    {
        if (!_socket.Poll((int)(seconds * 1e6), SelectMode.SelectRead))
            return null;
        return Encoding.UTF8.GetString(_buffer, 0, _socket.Receive(_buffer));
    }

    /// <summary>Those up to one that begins with a text.</summary>
    public List<string> Until(string start)
    {
        var all = new List<string>();
        while (Next() is { } text)
        {
            all.Add(text);
            if (text.StartsWith(start, StringComparison.Ordinal))
                return all;
        }

        throw new TimeoutException($"No '{start}' but: {string.Join(" | ", all)}");
    }

    /// <summary>What comes for a while.</summary>
    public List<string> For(double seconds)
    {
        var end = System.Diagnostics.Stopwatch.StartNew();
        var all = new List<string>();
        while (end.Elapsed.TotalSeconds < seconds)
        {
            if (Next(Math.Max(0, seconds - end.Elapsed.TotalSeconds)) is { } text)
                all.Add(text);
        }

        return all;
    }

    public void Dispose()
    {
        _socket.Dispose();
        if (_file is not null)
            File.Delete(_file);
    }
}
