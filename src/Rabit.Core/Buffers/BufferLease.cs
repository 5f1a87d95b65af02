using System;
using Rabit.Core.Buffers;

namespace Rabit.Core;

/// <summary>
/// The right to use one buffer of a <see cref="BufferPool"/>, for one owner at a time. It travels through queues as it
/// is: who pushed it does not touch it any more, who popped it returns it, or takes it over with <see cref="HandTo"/>
/// so that older copies are dead. Where a queue drops it, the queue returns it.
/// </summary>
public readonly struct BufferLease : IDisposable
{
    private readonly PooledBuffer? _buffer;
    private readonly int _generation;

    internal BufferLease(PooledBuffer buffer, int generation)
    {
        _buffer = buffer;
        _generation = generation;
    }

    /// <summary>Whether there is no buffer behind it: the default value.</summary>
    public bool IsEmpty => _buffer is null;

    /// <summary>The bytes.</summary>
    /// <exception cref="InvalidOperationException">
    /// It was handed on or returned, or is empty; the text names the pool and who has it.
    /// </exception>
    public Span<byte> Span => Use().Bytes;

    /// <summary>The bytes as an array, for what cannot take a span. Not to be kept.</summary>
    /// <exception cref="InvalidOperationException">See <see cref="Span"/>.</exception>
    public byte[] Array => Use().Bytes;

    /// <summary>Transfers the ownership: this lease and all its copies are invalid from now on.</summary>
    /// <param name="owner">The new owner, for errors and <see cref="BufferPool.Holders"/>.</param>
    /// <returns>The lease of the new owner.</returns>
    /// <exception cref="ArgumentException">The owner has no name.</exception>
    /// <exception cref="InvalidOperationException">See <see cref="Span"/>.</exception>
    public BufferLease HandTo(string owner)
    {
        if (string.IsNullOrEmpty(owner))
            throw new ArgumentException("The new owner of a buffer needs a name.", nameof(owner));
        PooledBuffer buffer = Use();
        return new BufferLease(buffer, buffer.Pool.HandOn(buffer, _generation, owner));
    }

    /// <summary>Returns the buffer. Does nothing where it was handed on or returned before, or is empty.</summary>
    public void Dispose() => _buffer?.Pool.Return(_buffer, _generation);

    private PooledBuffer Use()
    {
        PooledBuffer buffer = _buffer ?? throw new InvalidOperationException("An empty buffer lease was used.");
        buffer.Demand(_generation);
        return buffer;
    }
}
