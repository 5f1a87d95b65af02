using Rabit.Uav.Messages;

namespace Rabit.Uav.ImageProcessing;

/// <summary>What looks like a target in a picture. A plain value.</summary>
internal struct Detection
{
    public TargetColours Colour { get; set; }

    /// <summary>Pixels; the centre of the top left pixel is 0.</summary>
    public double CentreX { get; set; }

    /// <summary>Pixels; the centre of the top left pixel is 0.</summary>
    public double CentreY { get; set; }

    public double SideMetres { get; set; }

    /// <summary>0 to 1.</summary>
    public double Score { get; set; }
}
