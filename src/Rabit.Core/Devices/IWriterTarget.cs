namespace Rabit.Core;

/// <summary>What a blocking writer writes to: a serial line, a socket, a file, or a simulated stand-in.</summary>
/// <typeparam name="T">What one write takes.</typeparam>
public interface IWriterTarget<T>
{
    /// <summary>
    /// Whether <see cref="Write"/> may block its thread. A target that never does runs in virtual time too.
    /// </summary>
    bool Blocks { get; }

    /// <summary>
    /// Called once on the writer's thread before the first write, and again after each close that a
    /// <see cref="ReconnectPolicy"/> asks for. What it throws is the writer's fault.
    /// </summary>
    void Open();

    /// <summary>
    /// Writes one value. Called on the writer's thread only. What it throws ends the writer as faulted, or makes it
    /// close and open again.
    /// </summary>
    /// <param name="value">What the manager pushed.</param>
    void Write(in T value);

    /// <summary>
    /// Called from another thread when the writer did not end in time: a write that blocks must return soon.
    /// </summary>
    void Unblock();

    /// <summary>
    /// Called once on the writer's thread for each call of <see cref="Open"/>, after the last write, whatever ended it.
    /// </summary>
    void Close();
}
