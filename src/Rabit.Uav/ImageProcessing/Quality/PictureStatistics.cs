namespace Rabit.Uav.ImageProcessing.Quality;

/// <summary>What was measured of a picture, in levels of 255 and their squares. A plain value.</summary>
internal struct PictureStatistics
{
    /// <summary>Below it lie 5 % of the luma.</summary>
    public int DarkLevel { get; set; }

    /// <summary>Below it lie 95 % of the luma.</summary>
    public int BrightLevel { get; set; }

    /// <summary>Part of the pixels whose luma is at the upper end, 0 to 1.</summary>
    public double ClippedShare { get; set; }

    /// <summary>
    /// Mean square of the difference of neighbours: noise, and the part of the detail that neighbours do not share.
    /// </summary>
    public double NeighbourDifference { get; set; }

    /// <summary>
    /// Fine detail: how much more pixels differ that are two apart than neighbours do, mean square. White noise adds
    /// nothing to it, because it is in both.
    /// </summary>
    public double FineDetail { get; set; }

    /// <summary>Coarse detail: the same of pixels that are eight apart.</summary>
    public double CoarseDetail { get; set; }

    /// <summary>
    /// How much more detail there is along one direction than across it, whatever direction it is: the difference of
    /// the eigenvalues of the structure tensor. White noise adds nothing to it.
    /// </summary>
    public double DirectedDetail { get; set; }

    /// <summary>Part of the tiles of the picture that show nothing but noise, 0 to 1.</summary>
    public double FlatShare { get; set; }
}
