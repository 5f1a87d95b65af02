using System;

namespace Rabit.Latency.Forwarding;

/// <summary>What takes datagrams at one port and sends what is in them to another.</summary>
internal interface IForwarder : IDisposable
{
    /// <summary>Where it listens, on 127.0.0.1.</summary>
    int Port { get; }
}
