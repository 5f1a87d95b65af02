using System;

namespace Rabit.Core.Managers;

/// <summary>What a turn says of the next one: when it is due, and what may bring it forward.</summary>
internal readonly struct NextTurn
{
    private const int AnyCause = 255;

    private NextTurn(TimeSpan due, TimeSpan notBefore, int wanted)
    {
        Due = due;
        NotBefore = notBefore;
        Wanted = wanted;
    }

    /// <summary>The last turn was the last.</summary>
    public static NextTurn Never => default;

    /// <summary>When the timer wakes.</summary>
    public TimeSpan Due { get; }

    /// <summary>Until when a modelled unit of work keeps its manager busy; wakes are kept until then.</summary>
    public TimeSpan NotBefore { get; }

    /// <summary>The causes that end the sleep before it is due; zero when there is no next turn.</summary>
    public int Wanted { get; }

    public bool IsNever => Wanted == 0;

    /// <summary>At the due time or at any wake.</summary>
    public static NextTurn At(TimeSpan due, TimeSpan notBefore = default) => new(due, notBefore, AnyCause);

    /// <summary>At the due time and not before, except to stop; wakes are kept.</summary>
    public static NextTurn OnlyAt(TimeSpan due) => new(due, default, WakeUpEvent.Stop);

    /// <summary>When the start-up barrier opens; wakes are kept.</summary>
    public static NextTurn AtStart() => new(TimeSpan.MaxValue, default, WakeUpEvent.Stop | (int)WakeUpCauses.Start);
}
