using System;
using System.Collections.Generic;
using System.Linq;
using System.Runtime.CompilerServices;
using System.Threading;
using Rabit.Core.Time;
using Rabit.Core.WakeUp;

namespace Rabit.Core.Tests.Exploration;

/// <summary>
/// The points as the explorer sees them: each asks the recorder what the memory, the kernel or the clock answers.
/// </summary>
internal readonly unsafe struct ExploredSyncPoints : ISyncPoints
{
    public int Read(ref int location) => Perform(SyncKind.Read, ref location);

    public void Write(ref int location, int value) => Perform(SyncKind.Write, ref location, value);

    public bool IsMachine => false;

    public T Read<T>(ref T location) => (T)(object)Read(ref AsNumber(ref location));

    public void Write<T>(ref T location, in T value) => Write(ref AsNumber(ref location), (int)(object)value!);

    public int VolatileRead(ref int location) => Perform(SyncKind.VolatileRead, ref location);

    public void VolatileWrite(ref int location, int value) => Perform(SyncKind.VolatileWrite, ref location, value);

    public int Exchange(ref int location, int value) => Perform(SyncKind.Exchange, ref location, value);

    public int CompareExchange(ref int location, int value, int comparand)
        => Perform(SyncKind.CompareExchange, ref location, value, comparand);

    public long VolatileRead(ref long location)
        => Whole(Perform(new SyncOperation(SyncKind.VolatileRead, Mine.LocationOf(ref location))));

    public void VolatileWrite(ref long location, long value)
        => Perform(new SyncOperation(SyncKind.VolatileWrite, Mine.LocationOf(ref location), Number(value)));

    public long CompareExchange(ref long location, long value, long comparand)
        => Whole(Perform(new SyncOperation(
            SyncKind.CompareExchange, Mine.LocationOf(ref location), Number(value), Number(comparand))));

    public long InterlockedRead(ref long location)
        => Perform(new SyncOperation(SyncKind.InterlockedRead, Mine.LocationOf(ref location)));

    public void InterlockedWrite(ref long location, long value)
        => Perform(new SyncOperation(SyncKind.InterlockedWrite, Mine.LocationOf(ref location), checked((int)value)));

    public void FenceAllThreads() => Perform(new SyncOperation(SyncKind.FenceAllThreads));

    public void StoreBarrier() => Perform(new SyncOperation(SyncKind.StoreBarrier));

    public void LoadBarrier() => Perform(new SyncOperation(SyncKind.LoadBarrier));

    public void Fence() => Perform(new SyncOperation(SyncKind.Fence));

    public void Set(AutoResetEvent signal) => Perform(new SyncOperation(SyncKind.Set, Mine.SignalOf(signal)));

    public void Wait(AutoResetEvent signal, int milliseconds)
        => Perform(
            new SyncOperation(SyncKind.Wait, Mine.SignalOf(signal))
            {
                AtMost = TimeSpan.FromMilliseconds(milliseconds)
            });

    public void FutexWake(int* word) => Perform(SyncKind.FutexWake, ref *word);

    public void FutexWaitWhileZero(int* word, TimeSpan until, RunClock clock)
        => Perform(new SyncOperation(SyncKind.FutexWait, Mine.LocationOf(ref *word)) { Until = until });

    /// <summary>A remark of the model, on what has just been done.</summary>
    /// <param name="about">Compared: two notes that do the same have the same.</param>
    /// <param name="note">What it does.</param>
    public static void Note(object about, Action<ExploredState> note)
        => Perform(new SyncOperation(SyncKind.Note) { About = about, Note = note });

    /// <summary>A remark of the model, on what is done next.</summary>
    /// <param name="about">Compared: two notes that do the same have the same.</param>
    /// <param name="note">What it does.</param>
    /// <param name="mayNeverCome">Whether what is done next may as well never be done: no code may count on it.</param>
    public static void NoteNext(object about, Action<ExploredState> note, bool mayNeverCome = false)
        => Perform(new SyncOperation(SyncKind.NoteOfNext) { About = about, Note = note, MayNeverCome = mayNeverCome });

    /// <summary>What the piece of code that runs has read of a location so far, the first read first.</summary>
    public static IReadOnlyList<long> ReadsOf(ref long location)
        => [.. Mine.ReadsOf(Mine.LocationOf(ref location)).Select(Whole)];

    /// <summary>
    /// The oldest value that a plain read might be shown, now or ever after: views only grow. Where a check bears the
    /// newer ones if it bears the oldest, and the code does not, this stands for the read; no other thread sees whether
    /// one has read.
    /// </summary>
    public static int OldestSeen(ref int location) => Perform(SyncKind.ReadOldest, ref location);

    /// <summary>
    /// The memory of the explorer has 32-bit numbers: of a 64-bit word of two small halves it keeps 16 bits each.
    /// </summary>
    public static int Number(long word)
        => word >> 32 is >= 0 and <= short.MaxValue && (int)word is >= 0 and <= ushort.MaxValue
            ? ((int)(word >> 32) << 16) | (int)word
            : throw new InvalidOperationException($"The halves of the word {word:x} are not small.");

    // The explorer's memory has numbers only.
    private static ref int AsNumber<T>(ref T location)
    {
        if (typeof(T) != typeof(int))
            throw new NotSupportedException($"A {typeof(T)} cannot be explored.");
        return ref Unsafe.As<T, int>(ref location);
    }

    private static long Whole(int number) => ((long)(number >> 16) << 32) | (uint)(number & ushort.MaxValue);

    private static Recorder Mine
        => Recorder.Current ?? throw new InvalidOperationException("Nothing is explored on this thread.");

    private static int Perform(SyncKind kind, ref int location, int value = 0, int comparand = 0)
        => Perform(new SyncOperation(kind, Mine.LocationOf(ref location), value, comparand));

    private static int Perform(in SyncOperation operation) => Mine.Perform(operation);
}
