namespace Rabit.Vision;

/// <summary>How large the panels may be that <see cref="PanelFinder"/> looks for. A plain value; pixels.</summary>
public struct PanelLimits
{
    /// <summary>Side of the smallest, that of a square of its area.</summary>
    public double MinSide { get; set; }

    /// <summary>Side of the largest, that of a square of its area.</summary>
    public double MaxSide { get; set; }

    /// <summary>Side of the usual one: by it is taken what counts as the ground around one.</summary>
    public double UsualSide { get; set; }

    /// <summary>Whether <see cref="PanelShape.Form"/> is measured.</summary>
    public bool MeasuresForm { get; set; }
}
