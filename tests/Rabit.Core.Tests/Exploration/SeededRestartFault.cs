namespace Rabit.Core.Tests.Exploration;

/// <summary>A fault that is put into a restart, for the explorer to find.</summary>
public enum SeededRestartFault
{
    /// <summary>None: the code that flies.</summary>
    None,

    /// <summary>The wakes that came before the restart are forgotten with it.</summary>
    EarlierWakesForgotten,

    /// <summary>Those that came during the start-up are taken, and not given to the first unit of work.</summary>
    WakesOfTheStartUpForgotten,

    /// <summary>The first unit of work follows in the same step, without a look for a stop.</summary>
    RunsInTheSameStep,

    /// <summary>A wake during the back-off begins the start-up.</summary>
    WakeEndsTheBackOff,
}
