namespace Rabit.Vision;

/// <summary>An object in a picture that a template is trained from: the upright box around it, pixels.</summary>
/// <param name="left">Of its border; the first column of the picture begins at 0.</param>
/// <param name="top">Of its border; the first row of the picture begins at 0.</param>
/// <param name="width">Columns, above 0.</param>
/// <param name="height">Rows, above 0.</param>
public sealed class TrainingBox(double left, double top, double width, double height)
{
    /// <summary>Left border.</summary>
    public double Left { get; } = left;

    /// <summary>Upper border.</summary>
    public double Top { get; } = top;

    /// <summary>Columns.</summary>
    public double Width { get; } = width;

    /// <summary>Rows.</summary>
    public double Height { get; } = height;

    /// <summary>
    /// Direction of its long axis in the picture, radians clockwise from up, where it is known; null to have it found
    /// from the sides of the box and from what the other objects look like.
    /// </summary>
    public double? HeadingRadians { get; init; }

    /// <summary>
    /// Whether it is something like the object that is neither one of them nor an example of what is none, as a lorry
    /// among cars, or one that is hidden.
    /// </summary>
    public bool IsIgnored { get; init; }

    // The same in coordinates whose 0 is the centre of the first pixel.
    internal PixelRectangle Box => new(Left - 0.5, Top - 0.5, Left + Width - 0.5, Top + Height - 0.5);
}
