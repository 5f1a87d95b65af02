namespace Rabit.Core.Tests.Exploration;

/// <summary>
/// A thread of a model. Its code is cut into pieces where it keeps nothing but a value that can be compared, so that
/// the explorer knows two ways to the same place as one.
/// </summary>
internal abstract class ExploredThread(string name)
{
    public string Name { get; } = name;

    /// <summary>What the first piece begins with.</summary>
    public abstract object Begin { get; }

    /// <summary>Runs one piece.</summary>
    /// <returns>What the next begins with; null at the end. From inside a call: <see cref="Recorder.End"/>.</returns>
    public abstract object? Run(object from);
}
