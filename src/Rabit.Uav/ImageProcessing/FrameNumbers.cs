using System;

namespace Rabit.Uav.ImageProcessing;

/// <summary>Counts pictures that were lost by the gaps in their numbers.</summary>
internal sealed class FrameNumbers
{
    private long? _next;

    public long Lost { get; private set; }

    /// <summary>
    /// Takes the number of a picture that arrived. A number that goes back is a camera that was restarted, or a late
    /// picture.
    /// </summary>
    /// <param name="number">The number.</param>
    /// <param name="dropped">
    /// How many pictures found no room so far: of those before the first that arrived, the others were taken before the
    /// run.
    /// </param>
    /// <returns>False where it is the number of the picture before.</returns>
    public bool Take(long number, long dropped)
    {
        if (number == _next - 1)
            return false;
        if (_next is not { } next)
            Lost = Math.Min(number, dropped);
        else if (number > next)
            Lost += number - next;
        _next = number + 1;
        return true;
    }
}
