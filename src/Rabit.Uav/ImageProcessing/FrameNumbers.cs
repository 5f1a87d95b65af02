namespace Rabit.Uav.ImageProcessing;

/// <summary>Counts pictures that were lost by the gaps in their numbers.</summary>
internal sealed class FrameNumbers
{
    private long _next;

    public long Lost { get; private set; }

    /// <summary>
    /// Takes the number of a picture that arrived. A number that goes back is a camera that was restarted, or a late
    /// picture.
    /// </summary>
    public void Take(long number)
    {
        if (number > _next)
            Lost += number - _next;
        _next = number + 1;
    }
}
