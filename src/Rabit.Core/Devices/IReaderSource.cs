namespace Rabit.Core;

/// <summary>
/// What a blocking reader reads: a serial line, a socket, a file, or a scripted or simulated stand-in. The library owns
/// the thread and the queue; the source only reads.
/// </summary>
/// <typeparam name="T">What one read gives.</typeparam>
public interface IReaderSource<T>
{
    /// <summary>
    /// Whether <see cref="Read"/> may block its thread. A source that never does, and says when to ask again instead,
    /// runs in virtual time too.
    /// </summary>
    bool Blocks { get; }

    /// <summary>
    /// Called once on the reader's thread before the first read, and again after each close that a
    /// <see cref="ReconnectPolicy"/> asks for. What it throws is the reader's fault.
    /// </summary>
    /// <param name="context">The clock, and the way to end a wait.</param>
    void Open(ReaderContext context);

    /// <summary>
    /// Reads one value. Called on the reader's thread only. What it throws ends the reader as faulted, or makes it
    /// close and open again.
    /// </summary>
    /// <param name="value">The value, where the step says so.</param>
    /// <returns>What it came to.</returns>
    ReaderStep Read(out T value);

    /// <summary>
    /// Called from another thread when the reader stops: a read that blocks must return soon, and no later one may
    /// block.
    /// </summary>
    void Unblock();

    /// <summary>
    /// Called once on the reader's thread for each call of <see cref="Open"/>, after the last read, whatever ended it.
    /// </summary>
    void Close();
}
