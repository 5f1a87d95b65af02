using System;
using System.Threading;

namespace Rabit.Core.Buffers;

/// <summary>
/// One buffer of a pool. Each change of hands is a new generation, and only a lease of the newest one is good, so that
/// copies of a lease cannot be used after it was handed on or returned.
/// </summary>
internal sealed class PooledBuffer(BufferPool pool, int length)
{
    private int _generation;   // written under the pool's lock, read anywhere

    public BufferPool Pool { get; } = pool;

    public byte[] Bytes { get; } = new byte[length];

    /// <summary>Who has it; null while it is free. Written under the pool's lock.</summary>
    public string? Owner { get; private set; }

    /// <summary>Who had it before, for errors.</summary>
    public string? LastOwner { get; private set; }

    public int Generation => Volatile.Read(ref _generation);

    /// <summary>Passes it on. Under the pool's lock.</summary>
    /// <returns>The new generation.</returns>
    public int Pass(string? owner)
    {
        LastOwner = Owner ?? LastOwner;
        Owner = owner;
        Volatile.Write(ref _generation, unchecked(_generation + 1));
        return _generation;
    }

    public void Demand(int generation)
    {
        if (Generation != generation)
            ThrowNotOwned();
    }

    private void ThrowNotOwned() => throw new InvalidOperationException(Owner is { } owner
        ? $"A buffer of pool '{Pool.Name}' is used by one who has handed it on or given it back; '{owner}' has it now."
        : $"A buffer of pool '{Pool.Name}' is used after it was returned; '{LastOwner}' had it last.");
}
