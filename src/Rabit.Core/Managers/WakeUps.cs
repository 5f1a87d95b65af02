namespace Rabit.Core.Managers;

/// <summary>What a sleeper takes when it wakes: the causes, how many wakes they came from, and whether to stop instead.</summary>
internal readonly struct WakeUps(WakeUpCauses causes, int count, bool stop)
{
    public WakeUpCauses Causes { get; } = causes;

    public int Count { get; } = count;

    public bool Stop { get; } = stop;

    public WakeUps With(WakeUpCauses more) => new(Causes | more, Count, Stop);
}
