namespace Rabit.Mavlink;

/// <summary>
/// The parameters that a <see cref="MavlinkParameterServer"/> serves. Used by one thread. <see
/// cref="MavlinkParameterList"/> is one; who keeps the values elsewhere writes another.
/// </summary>
public interface IMavlinkParameterStore
{
    /// <summary>How many there are; at most 32 767.</summary>
    int Count { get; }

    /// <summary>One parameter.</summary>
    /// <param name="index">0 to <see cref="Count"/> - 1; the same parameter has the same index.</param>
    /// <returns>Its name, type and value as they stand.</returns>
    MavlinkParameterValue this[int index] { get; }

    /// <summary>Sets a parameter, or refuses it.</summary>
    /// <param name="change">What is wanted. The value fits the type of the parameter.</param>
    /// <param name="refusal">Why not, where it is refused.</param>
    /// <returns>Whether it was set.</returns>
    bool TrySet(in MavlinkParameterChange change, out MavlinkParameterRefusal refusal);
}
