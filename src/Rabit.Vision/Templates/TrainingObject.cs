using System;

namespace Rabit.Vision;

/// <summary>An object to train with: where it is, and the headings that it may have by the sides of its box.</summary>
internal sealed class TrainingObject
{
    private const double ClearDegrees = 12;

    private TrainingObject(PixelRectangle box, double heading, double other)
        => (Box, Heading, Other) = (box, heading, other);

    public PixelRectangle Box { get; }

    /// <summary>Radians from up; which end is the front is not known.</summary>
    public double Heading { get; }

    /// <summary>The other heading of a box of such sides; the same for one that is upright or was given.</summary>
    public double Other { get; }

    /// <summary>Whether both are nearly the same.</summary>
    public bool IsClear => Math.Abs(Trig.Sin(Heading - Other)) <= Trig.Sin(2 * ClearDegrees * Math.PI / 180);

    public static TrainingObject From(TrainingBox box, double widthByLength)
    {
        if (box.HeadingRadians is { } given)
            return new TrainingObject(box.Box, given, given);
        // The box of a rectangle that is turned by an angle from horizontal has the sides cos + q sin and sin + q cos.
        double sought = Math.Log(box.Height / box.Width);
        (double best, double least) = (0, double.MaxValue);
        for (int degrees = 0; degrees <= 90; degrees++)
        {
            (double cos, double sin) = (Trig.Cos(degrees * Math.PI / 180), Trig.Sin(degrees * Math.PI / 180));
            double off = Math.Abs(
                Math.Log((sin + (widthByLength * cos)) / (cos + (widthByLength * sin))) - sought);
            if (off < least)
                (best, least) = (degrees * Math.PI / 180, off);
        }

        return new TrainingObject(box.Box, (Math.PI / 2) - best, (Math.PI / 2) + best);
    }
}
