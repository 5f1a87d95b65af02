namespace Rabit.Hosting;

/// <summary>How a reactor is, from good to bad.</summary>
internal enum ReactorCondition
{
    Good,
    Degraded,
    Faulted,
    NotRunning,
    Hangs,
}
