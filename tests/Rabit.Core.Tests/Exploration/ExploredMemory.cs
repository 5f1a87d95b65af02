using System;

namespace Rabit.Core.Tests.Exploration;

/// <summary>
/// A memory that may show each thread other values than the newest, within the rules of the .NET memory model.
/// </summary>
/// <remarks>
/// Each location keeps its writes in order. A thread has a view: for each location the oldest write that it may still
/// be shown. It may be shown any later one, and its view moves there. So a plain or volatile write may stay unseen
/// while its thread goes on (a store buffer), plain writes may come to light in another order than they were made, and
/// plain reads may be answered early (Arm).
/// <list type="bullet">
/// <item>A volatile write hands on its thread's view, and a volatile read takes it over: what was done before is seen
/// after.</item>
/// <item>A plain write may move before racing writes of other threads that its thread has not seen, but not between an
/// interlocked operation and the write that this read; so may a volatile one.</item>
/// <item>An interlocked operation sees the newest write, hands on and takes over as volatile ones do, and is a full
/// fence.</item>
/// <item>A full fence takes over what all fences before it have handed on, and all that plain reads before it were
/// shown.</item>
/// </list>
/// This is the view-based form of release and acquire with fences (Kang, Hur, Lahav, Vafeiadis, Dreyer: "A promising
/// semantics for relaxed-memory concurrency", POPL 2017, sections 2 to 4), without promises: a read is not delayed past
/// a later write of its thread. It allows all that x86 does, and more than Arm does (two readers may see two writers'
/// writes in different orders).
/// </remarks>
internal sealed class ExploredMemory(StateShape shape, MemoryModel model)
{
    // A thread's own view, what a fence would add to it, and what its plain writes hand on: its view at the last fence.
    private const int Own = 0;
    private const int AtFence = 1;
    private const int HandedOn = 2;

    // How a write was made.
    private const int ByInterlocked = 1;

    private readonly int _locations = shape.Locations;
    private readonly int _fences = shape.Views + (3 * shape.Threads * shape.Locations);

    public int Newest(int[] s, int location) => s[Write(location, s[shape.Counts + location] - 1)];

    /// <summary>The oldest value that a thread might be shown.</summary>
    public int Oldest(int[] s, int thread, int location)
    {
        int oldest = model switch
        {
            MemoryModel.SequentiallyConsistent => s[shape.Counts + location] - 1,
            MemoryModel.StoreBuffers => Math.Max(s[View(thread, Own) + location], s[_fences + location]),
            _ => s[View(thread, Own) + location],
        };
        return s[Write(location, oldest)];
    }

    /// <summary>Reads a write, by choice: 0 is the newest.</summary>
    /// <returns>False where there is no such choice.</returns>
    public bool TryRead(int[] s, int thread, int location, int choice, bool isVolatile, out int value)
    {
        value = 0;
        int count = s[shape.Counts + location];
        int own = View(thread, Own);
        int index = count - 1 - choice;
        if (index < s[own + location] || (choice > 0 && model == MemoryModel.SequentiallyConsistent))
            return false;
        int write = Write(location, index);
        value = s[write];
        Join(s, View(thread, AtFence), write + 2);
        Raise(s, View(thread, AtFence) + location, index);
        Raise(s, own + location, index);
        if (isVolatile)
            Join(s, own, write + 2);
        if (model == MemoryModel.StoreBuffers && s[write + 1] != WriterMark(thread))
            Join(s, _fences, write + 2);
        return true;
    }

    /// <summary>
    /// Writes at a place among the writes that the thread has not seen, by choice: 0 is after them all.
    /// </summary>
    public bool TryWrite(int[] s, int thread, int location, int choice, bool isVolatile, int value)
    {
        int index = s[shape.Counts + location];
        for (int skipped = 0; skipped < choice; skipped++)
        {
            // Not between an interlocked operation and what it read.
            do
                index--;
            while (s[Write(location, index) + 1] == ByInterlocked);
            if (model == MemoryModel.SequentiallyConsistent || index <= s[View(thread, Own) + location])
                return false;
        }

        Insert(s, location, index, value, WriterMark(thread));
        Raise(s, View(thread, Own) + location, index);
        Raise(s, View(thread, AtFence) + location, index);
        int handedOn = Write(location, index) + 2;
        Join(s, handedOn, View(thread, isVolatile ? Own : HandedOn));
        Raise(s, handedOn + location, index);
        return true;
    }

    /// <summary>Reads the newest write, and writes after it unless the value is to stay.</summary>
    public int Interlocked(int[] s, int thread, int location, int value, int? comparand, bool isRead)
    {
        TakeOverFences(s, thread);
        int own = View(thread, Own);
        int index = s[shape.Counts + location] - 1;
        int seen = s[Write(location, index)];
        Raise(s, own + location, index);
        Join(s, own, Write(location, index) + 2);
        if (!isRead && (comparand is null || comparand == seen))
        {
            Insert(s, location, index + 1, value, ByInterlocked);
            Raise(s, own + location, index + 1);
            Join(s, Write(location, index + 1) + 2, own);
        }

        HandOnToFences(s, thread);
        return seen;
    }

    public void Fence(int[] s, int thread)
    {
        TakeOverFences(s, thread);
        HandOnToFences(s, thread);
    }

    /// <summary>What plain writes after it hand on: all that the thread has seen before it.</summary>
    public void StoreBarrier(int[] s, int thread)
        => Array.Copy(s, View(thread, Own), s, View(thread, HandedOn), _locations);

    /// <summary>Takes over what plain reads before it were shown.</summary>
    public void LoadBarrier(int[] s, int thread) => Join(s, View(thread, Own), View(thread, AtFence));

    /// <summary>A signal shows the thread that it wakes what its setter saw; it is taken for no fence.</summary>
    public void HandOn(int[] s, int thread, int signalView) => Join(s, signalView, View(thread, Own));

    public void TakeOver(int[] s, int thread, int signalView)
    {
        Join(s, View(thread, Own), signalView);
        Join(s, View(thread, AtFence), signalView);
    }

    /// <summary>Forgets the writes that no thread may be shown any more.</summary>
    public void Forget(int[] s, bool[] hasEnded)
    {
        for (int thread = 0; thread < shape.Threads && model != MemoryModel.Weak; thread++)
        {
            if (!hasEnded[thread])
                ShowToAll(s, thread);
        }

        for (int location = 0; location < _locations; location++)
        {
            int oldest = s[shape.Counts + location] - 1;
            for (int thread = 0; thread < shape.Threads; thread++)
            {
                if (!hasEnded[thread])
                    oldest = Math.Min(oldest, s[View(thread, Own) + location]);
            }

            if (oldest > 0)
                Shift(s, location, oldest);
        }
    }

    public void ForgetThread(int[] s, int thread) => Array.Clear(s, View(thread, Own), 3 * _locations);

    // Whose buffer a write is in, where there are any.
    private int WriterMark(int thread) => model == MemoryModel.StoreBuffers ? 2 + thread : 0;

    private int View(int thread, int kind) => shape.Views + (((3 * thread) + kind) * _locations);

    private int Write(int location, int index)
        => shape.Memory + (((location * shape.Writes) + index) * shape.WriteSize);

    private void TakeOverFences(int[] s, int thread)
    {
        Join(s, View(thread, Own), View(thread, AtFence));
        Join(s, View(thread, Own), _fences);
    }

    // What has left the store buffers all processors see.
    private void ShowToAll(int[] s, int thread)
    {
        for (int location = 0; location < _locations && model == MemoryModel.SequentiallyConsistent; location++)
            s[_fences + location] = s[shape.Counts + location] - 1;
        Join(s, View(thread, Own), _fences);
        Join(s, View(thread, AtFence), View(thread, Own));
    }

    private void HandOnToFences(int[] s, int thread)
    {
        int own = View(thread, Own);
        Array.Copy(s, own, s, _fences, _locations);
        Array.Copy(s, own, s, View(thread, AtFence), _locations);
        Array.Copy(s, own, s, View(thread, HandedOn), _locations);
    }

    private void Join(int[] s, int into, int from)
    {
        for (int location = 0; location < _locations; location++)
            Raise(s, into + location, s[from + location]);
    }

    private static void Raise(int[] s, int entry, int index)
    {
        if (s[entry] < index)
            s[entry] = index;
    }

    private void Insert(int[] s, int location, int index, int value, int mark)
    {
        int count = s[shape.Counts + location]++;
        if (count == shape.Writes)
            throw new InvalidOperationException(
                $"Location {location} has more than {shape.Writes} writes in sight: the shape of the state is too "
                    + "small.");
        int write = Write(location, index);
        if (index < count)
        {
            Array.Copy(s, write, s, write + shape.WriteSize, (count - index) * shape.WriteSize);
            ForEachView(s, location, index, static (entry, at) => entry >= at ? entry + 1 : entry);
        }

        Array.Clear(s, write, shape.WriteSize);
        s[write] = value;
        s[write + 1] = mark;
        s[write + 2 + location] = index;
    }

    private void Shift(int[] s, int location, int by)
    {
        int count = s[shape.Counts + location] -= by;
        Array.Copy(s, Write(location, by), s, Write(location, 0), count * shape.WriteSize);
        Array.Clear(s, Write(location, count), by * shape.WriteSize);
        s[Write(location, 0) + 1] = 0;   // the oldest in sight: nothing can move before it, and all see it
        ForEachView(s, location, by, static (entry, by) => Math.Max(0, entry - by));
    }

    private void ForEachView(int[] s, int location, int number, Func<int, int, int> change)
    {
        for (int view = shape.Views; view < shape.SignalViews; view += _locations)
            s[view + location] = change(s[view + location], number);
        for (int signal = 0; signal < shape.Signals; signal++)
        {
            int entry = shape.SignalViews + (signal * (1 + _locations)) + 1 + location;
            s[entry] = change(s[entry], number);
        }

        for (int other = 0; other < _locations; other++)
        {
            for (int index = 0; index < s[shape.Counts + other]; index++)
            {
                int entry = Write(other, index) + 2 + location;
                s[entry] = change(s[entry], number);
            }
        }
    }
}
