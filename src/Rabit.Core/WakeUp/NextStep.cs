using System;

namespace Rabit.Core.WakeUp;

/// <summary>What a step returns about the next one: when it is due, and which wake-ups may bring it forward.</summary>
internal readonly struct NextStep
{
    private NextStep(TimeSpan due, TimeSpan notBefore, int wanted, TimeSpan spin = default, bool lends = false)
    {
        Due = due;
        NotBefore = notBefore;
        Wanted = wanted;
        Spin = spin;
        Lends = lends;
    }

    /// <summary>There is no next step.</summary>
    public static NextStep Never => default;

    /// <summary>When the timer wakes.</summary>
    public TimeSpan Due { get; }

    /// <summary>Until when a modelled unit of work keeps its manager busy; wakes are kept until then.</summary>
    public TimeSpan NotBefore { get; }

    /// <summary>The causes that end the sleep before it is due; zero when there is no next step.</summary>
    public int Wanted { get; }

    /// <summary>How long to look for a wake before the sleep; no sleep where one comes.</summary>
    public TimeSpan Spin { get; }

    /// <summary>Whether another thread may run steps during the sleep.</summary>
    public bool Lends { get; }

    public bool IsNever => Wanted == 0;

    /// <summary>At the due time or at any wake.</summary>
    public static NextStep At(
        TimeSpan due, TimeSpan notBefore = default, TimeSpan spin = default, bool lends = false)
        => new(due, notBefore, WakeUpEvent.Any, spin, lends);

    /// <summary>At the due time and not before, except to stop; wakes are kept.</summary>
    public static NextStep OnlyAt(TimeSpan due) => new(due, default, WakeUpEvent.Stop);

    /// <summary>When the start-up barrier opens; wakes are kept.</summary>
    public static NextStep AtStart() => new(TimeSpan.MaxValue, default, WakeUpEvent.Stop | (int)WakeUpCauses.Start);
}
