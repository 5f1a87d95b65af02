namespace Rabit.Vision;

/// <summary>A place that looks like a template. A plain value.</summary>
public struct TemplateMatch
{
    /// <summary>Column of its centre, pixels; the centre of the top left pixel is 0.</summary>
    public double CentreX { get; set; }

    /// <summary>Row of its centre, pixels; the centre of the top left pixel is 0.</summary>
    public double CentreY { get; set; }

    /// <summary>
    /// Direction of its long axis on the plane, radians from the plane's x axis to its y axis, 0 to pi: which end is
    /// the front is not known.
    /// </summary>
    public double HeadingRadians { get; set; }

    /// <summary>Between one heading that was compared and the next, radians: it may be half of that off.</summary>
    public double HeadingStepRadians { get; set; }

    /// <summary>Distance from the border between the object and other things, in the template's own measure.</summary>
    public double Score { get; set; }

    /// <summary>How probable it is the object, 0 to 1, as training found it on pictures that were left out.</summary>
    public double Probability { get; set; }

    /// <summary>How far a pixel reaches on the plane there.</summary>
    public PlaneScale Scale { get; set; }
}
