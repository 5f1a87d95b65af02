namespace Rabit.Core.Tests.Exploration;

/// <summary>The mark of a stage: that of the library, or a twin with a fault.</summary>
internal abstract class StageMarkUnderTest
{
    /// <summary>The manager enters a stage, of one kind at even times and of another at odd ones.</summary>
    public abstract void Enter(int time);

    /// <returns>Whether it was found hanging.</returns>
    public abstract bool Leave();

    /// <summary>The watchdog looks.</summary>
    public abstract bool TryRead(out int seen, out int kind, out int since);

    public abstract bool TryMarkHanging(int seen);
}
