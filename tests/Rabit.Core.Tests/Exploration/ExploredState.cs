using System;

namespace Rabit.Core.Tests.Exploration;

/// <summary>
/// Where everything stands between two steps. The model may look at the time and keep numbers of its own in it.
/// </summary>
internal sealed class ExploredState(StateShape shape)
{
    private const int NowAt = 0;
    private const int TicksLeftAt = 1;
    private const int EarlyReturnsLeftAt = 2;

    private readonly int[] _numbers = new int[shape.Size];

    public int[] Numbers => _numbers;

    /// <summary>What a broken promise is called; null while all are kept.</summary>
    public string? Fault { get; private set; }

    public TimeSpan Now
    {
        get => new(_numbers[NowAt]);
        set => _numbers[NowAt] = checked((int)value.Ticks);
    }

    /// <summary>How often time may still pass.</summary>
    public ref int TicksLeft => ref _numbers[TicksLeftAt];

    /// <summary>How often a wait may still return without a reason.</summary>
    public ref int EarlyReturnsLeft => ref _numbers[EarlyReturnsLeftAt];

    public ref int Place(int thread) => ref _numbers[StateShape.Header + (3 * thread)];

    /// <summary>How far a wait of the thread is: 0 not begun, 1 it sleeps, 2 it was woken.</summary>
    public ref int WaitStage(int thread) => ref _numbers[StateShape.Header + (3 * thread) + 1];

    /// <summary>When the wait of the thread ends by itself; 0 where it does not wait.</summary>
    public ref int Deadline(int thread) => ref _numbers[StateShape.Header + (3 * thread) + 2];

    /// <summary>A number of the model's own.</summary>
    public ref int Note(int number) => ref _numbers[StateShape.Header + (3 * shape.Threads) + number];

    public ref int SignalIsSet(int signal) => ref _numbers[SignalView(signal) - 1];

    public int SignalView(int signal) => shape.SignalViews + (signal * (1 + shape.Locations)) + 1;

    /// <summary>Breaks a promise, unless it holds.</summary>
    public void Require(bool holds, string fault)
    {
        if (!holds)
            Fault ??= fault;
    }

    public void CopyFrom(ExploredState other)
    {
        Array.Copy(other._numbers, _numbers, shape.Memory);
        for (int location = 0; location < shape.Locations; location++)
            Array.Copy(
                other._numbers, FirstWrite(location), _numbers, FirstWrite(location),
                EndOfWrites(location) - FirstWrite(location));
        Fault = other.Fault;
    }

    /// <summary>
    /// The state in 128 bits: two states with the same ones are taken for one. Of 10^8 states two different ones do so
    /// once in 10^22.
    /// </summary>
    public StateKey Key()
    {
        var key = default(StateKey);
        key.Add(_numbers, 0, shape.Memory);
        for (int location = 0; location < shape.Locations; location++)
            key.Add(_numbers, FirstWrite(location), EndOfWrites(location));
        return key;
    }

    private int FirstWrite(int location) => shape.Memory + (location * shape.Writes * shape.WriteSize);

    // Of those in sight; what lies behind them means nothing.
    private int EndOfWrites(int location)
        => FirstWrite(location) + (_numbers[shape.Counts + location] * shape.WriteSize);
}
