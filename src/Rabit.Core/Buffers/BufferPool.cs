using System;
using System.Collections.Generic;
using System.Linq;
using Rabit.Core.Buffers;
using Rabit.Core.Locks;

namespace Rabit.Core;

/// <summary>
/// A fixed number of large buffers, made once and used again, for data that is too large to copy: pictures, scans,
/// recordings. The one who rents a buffer owns it alone, passes it on through a queue, or returns it (contract 2.5).
/// </summary>
/// <remarks>
/// Any thread. A buffer that is never returned is missing from then on: <see cref="Holders"/> says who has it, and a
/// run that watches the pool (<see cref="RabitWorkspace.Watch"/>) ends with an error that says so.
/// </remarks>
/// <example>
/// <code>
/// var pictures = new BufferPool("pictures", count: 8, bufferBytes: 640 * 480 * 3);
/// if (pictures.TryRent("camera", out BufferLease picture))
/// {
///     Fill(picture.Span);
///     if (_pictures.Push(picture) == PushResult.Rejected)
///         picture.Dispose();   // else the receiver returns it, or a queue that drops it
/// }
/// </code>
/// </example>
public sealed class BufferPool
{
    // No wiring knows who rents: it may be a manager that has asked for a priority.
    private readonly EndpointLock _gate = new(inheritsPriority: true);
    private readonly Stack<PooledBuffer> _free;   // under _gate
    private readonly PooledBuffer[] _all;
    private long _refused;                        // under _gate

    /// <summary>Makes all buffers.</summary>
    /// <param name="name">Names the pool in errors.</param>
    /// <param name="count">How many buffers, at least 1.</param>
    /// <param name="bufferBytes">How many bytes in each, at least 1.</param>
    /// <exception cref="ArgumentException">The name is empty, or a number not positive.</exception>
    public BufferPool(string name, int count, int bufferBytes)
    {
        if (string.IsNullOrWhiteSpace(name))
            throw new ArgumentException("A pool needs a name.", nameof(name));
        if (count < 1)
            throw new ArgumentOutOfRangeException(nameof(count), count, $"Pool '{name}' needs at least one buffer.");
        if (bufferBytes < 1)
            throw new ArgumentOutOfRangeException(
                nameof(bufferBytes), bufferBytes, $"A buffer of pool '{name}' needs at least one byte.");
        Name = name;
        BufferBytes = bufferBytes;
        _all = Enumerable.Range(0, count).Select(_ => new PooledBuffer(this, bufferBytes)).ToArray();
        _free = new Stack<PooledBuffer>(_all);
    }

    /// <summary>The name.</summary>
    public string Name { get; }

    /// <summary>How many bytes each buffer has.</summary>
    public int BufferBytes { get; }

    /// <summary>How many buffers there are.</summary>
    public int Count => _all.Length;

    /// <summary>How many are not rented now.</summary>
    public int Free
    {
        get
        {
            using (_gate.Enter())
                return _free.Count;
        }
    }

    /// <summary>How often none was free.</summary>
    public long Refused
    {
        get
        {
            using (_gate.Enter())
                return _refused;
        }
    }

    /// <summary>
    /// Rents a buffer, if one is free. Its bytes are what its last owner left in it. Allocates nothing.
    /// </summary>
    /// <param name="owner">Who rents it, for errors and <see cref="Holders"/>.</param>
    /// <param name="lease">The buffer; empty if the answer is false.</param>
    /// <exception cref="ArgumentException">The owner has no name.</exception>
    public bool TryRent(string owner, out BufferLease lease)
    {
        if (string.IsNullOrEmpty(owner))
            throw new ArgumentException($"Who rents from pool '{Name}' needs a name.", nameof(owner));
        using (_gate.Enter())
        {
            if (_free.Count == 0)
            {
                _refused++;
                lease = default;
                return false;
            }

            PooledBuffer buffer = _free.Pop();
            lease = new BufferLease(buffer, buffer.Pass(owner));
            return true;
        }
    }

    /// <summary>
    /// Who holds the buffers that are rented now, one name for each: at the end of a run those that were not returned.
    /// </summary>
    public IReadOnlyList<string> Holders()
    {
        using (_gate.Enter())
            return _all.Where(b => b.Owner is not null).Select(b => b.Owner!).ToArray();
    }

    /// <summary>
    /// How full it is and who has what, in one line for a log: at the end of a run, who did not return.
    /// </summary>
    public string Describe()
    {
        using (_gate.Enter())
        {
            string state = FormattableString.Invariant(
                $"Pool '{Name}': {_free.Count} of {_all.Length} buffers are free, {_refused} times none was");
            return string.Join("; ", new[] { state }.Concat(HolderTexts())) + ".";
        }
    }

    /// <summary>Whether who waits for its lock lends its priority to who holds it.</summary>
    internal bool InheritsPriority => _gate.InheritsPriority;

    /// <summary>The owners of buffers that should all have been returned; null when there are none.</summary>
    internal string? FindLeak()
    {
        using (_gate.Enter())
        {
            return _free.Count == _all.Length
                ? null
                : $"Pool '{Name}' did not get all of its buffers back: {string.Join("; ", HolderTexts())}.";
        }
    }

    internal int HandOn(PooledBuffer buffer, int generation, string owner)
    {
        using (_gate.Enter())
        {
            buffer.Demand(generation);
            return buffer.Pass(owner);
        }
    }

    internal void Return(PooledBuffer buffer, int generation)
    {
        using (_gate.Enter())
        {
            if (buffer.Generation != generation)
                return;
            buffer.Pass(owner: null);
            _free.Push(buffer);
        }
    }

    // Under _gate.
    private IEnumerable<string> HolderTexts() => _all
        .Where(b => b.Owner is not null)
        .GroupBy(b => b.Owner!, StringComparer.Ordinal)
        .OrderBy(g => g.Key, StringComparer.Ordinal)
        .Select(g => FormattableString.Invariant($"'{g.Key}' has {g.Count()}"));
}
