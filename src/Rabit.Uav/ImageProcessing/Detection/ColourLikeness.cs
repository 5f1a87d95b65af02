namespace Rabit.Uav.ImageProcessing;

/// <summary>How like the colour of a patch is to one that is searched for; costs are squared deviations.</summary>
internal struct ColourLikeness
{
    public double Cost;

    public double Darkness;

    /// <summary>How much of the ground the blur mixes into it, 0 to 1.</summary>
    public double Mixed;

    /// <summary>White or black.</summary>
    public bool IsNeutral;

    /// <summary>Of a light grey, its contrast with usual ground as a part of that of white; 1 for all others.</summary>
    public double PartOfWhite;
}
