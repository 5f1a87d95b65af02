using System;
using System.Runtime.InteropServices;
using System.Threading;
using Rabit.Latency.Native;

namespace Rabit.Latency.Throughput;

/// <summary>
/// How a receiver without Rabit is woken, and only while it sleeps: it says that it is about to, looks again, and waits
/// on a futex; a sender reads after each push whether it has said so. Full fences on both sides.
/// </summary>
internal sealed class RingWaker : IDisposable
{
    private readonly FutexWord _word = new();
    private Mark _mark;

    public void AfterPush()
    {
        Interlocked.MemoryBarrier();   // the value before the look
        if (Volatile.Read(ref _mark.Sleeps) != 0 && Interlocked.Exchange(ref _mark.Sleeps, 0) != 0)
            _word.Set();
    }

    /// <summary>Says that the receiver is about to sleep; it must look at the queue once more.</summary>
    public void Announce() => Interlocked.Exchange(ref _mark.Sleeps, 1);

    public void Withdraw() => Volatile.Write(ref _mark.Sleeps, 0);

    public void Wait() => _word.Wait();

    public void Dispose() => _word.Dispose();

    // Away from everything else by a pair of cache lines.
    [StructLayout(LayoutKind.Explicit, Size = 256)]
    private struct Mark
    {
        [FieldOffset(128)]
        public int Sleeps;
    }
}
