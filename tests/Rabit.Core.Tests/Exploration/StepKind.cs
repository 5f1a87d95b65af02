namespace Rabit.Core.Tests.Exploration;

/// <summary>What came of trying a choice of a thread.</summary>
internal enum StepKind
{
    Taken,

    /// <summary>A wait returned early: it may, but no code may count on it.</summary>
    WithoutReason,

    /// <summary>The thread waits, and there is nothing to go on for.</summary>
    NotNow,

    /// <summary>Nor are there any higher ones.</summary>
    NoSuchChoice,
}
