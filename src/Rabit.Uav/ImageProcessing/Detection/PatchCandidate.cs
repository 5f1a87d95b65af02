using Rabit.Uav.Messages;
using Rabit.Vision;

namespace Rabit.Uav.ImageProcessing;

/// <summary>What a patch of a picture may be.</summary>
internal struct PatchCandidate
{
    /// <summary>Index in the classes of the detector: the likeliest.</summary>
    public int Class;

    /// <summary>Index in the table of colours.</summary>
    public int Colour;

    /// <summary>How unlike to its class; see <see cref="PatchCost"/>.</summary>
    public double Cost;

    /// <summary>The part of the cost that is of its colour.</summary>
    public double ColourCost;

    /// <summary>Whether its colour is white.</summary>
    public bool IsWhite;

    /// <summary>Whether only pixels whose colour is clear were joined.</summary>
    public bool IsStrong;

    /// <summary>How many patches it was put together of.</summary>
    public int Parts;

    /// <summary>Side on the ground of a square of its area, metres.</summary>
    public double SideMetres;

    /// <summary>Where it points; null where that was not measured.</summary>
    public TargetBearing? Bearing;

    public PatchShape Shape;
}
