namespace Rabit.Core.Tests.Exploration;

/// <summary>How large a state is: all of it lies in one array of numbers, which is quick to copy.</summary>
internal sealed class StateShape
{
    public StateShape(int threads, int locations, int writes, int signals, int notes)
    {
        (Threads, Locations, Writes, Signals, Notes) = (threads, locations, writes, signals, notes);
        WriteSize = 2 + locations;
        Views = Header + (3 * threads) + notes;
        SignalViews = Views + (3 * threads * locations) + locations;
        Counts = SignalViews + (signals * (1 + locations));
        Memory = Counts + locations;
        Size = Memory + (locations * writes * WriteSize);
    }

    public const int Header = 3;

    public int Threads { get; }

    public int Locations { get; }

    /// <summary>How many writes of a location may be in sight at one time.</summary>
    public int Writes { get; }

    public int Signals { get; }

    public int Notes { get; }

    /// <summary>
    /// A write: its value, whether an interlocked operation made it, and what it shows to the thread that reads it.
    /// </summary>
    public int WriteSize { get; }

    public int Views { get; }

    public int SignalViews { get; }

    public int Counts { get; }

    public int Memory { get; }

    public int Size { get; }
}
