using System.Collections.Generic;

namespace Rabit.Vision;

/// <summary>A picture to train with, as the search sees it.</summary>
internal sealed class TrainingPicture
{
    public BrightnessPlane Plane { get; } = new();

    public PlaneScale Scale { get; init; }

    public string Group { get; init; } = "";

    /// <summary>Of all of it.</summary>
    public PixelRectangle Frame { get; init; }

    public List<PixelRectangle> Ignored { get; } = [];

    public List<TrainingObject> Objects { get; } = [];

    /// <summary>Whether a place lies on an object or an ignored thing, or on its margin.</summary>
    public bool IsTaken(double x, double y, double margin)
    {
        foreach (PixelRectangle box in Ignored)
        {
            if (box.Grown(margin).Contains(x, y))
                return true;
        }

        foreach (TrainingObject one in Objects)
        {
            if (one.Box.Grown(margin).Contains(x, y))
                return true;
        }

        return false;
    }
}
