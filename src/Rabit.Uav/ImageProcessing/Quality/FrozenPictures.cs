using System;
using Rabit.Geodesy;

namespace Rabit.Uav.ImageProcessing.Quality;

/// <summary>
/// Whether a camera repeats a picture although it moves on: what is compared with a reference, and where that was.
/// </summary>
internal sealed class FrozenPictures
{
    // Two pictures are compared when the ground has moved by twice the distance at which coarse detail is measured.
    private const double MinPixelsMoved = 16;

    // A vehicle that hovers says that it moves, by the noise of its position and attitude, where a stabilised camera
    // gives one picture again and again.
    private const double MinMetresMoved = 2;

    private GeodeticPosition? _reference;

    /// <summary>Whether the last picture was one that had been seen before.</summary>
    public bool IsFrozen { get; private set; }

    /// <summary>
    /// Takes the next picture. Once frozen it stays so until a picture differs, also where the vehicle hovers
    /// meanwhile.
    /// </summary>
    /// <param name="isSame">Whether it shows the same as the reference.</param>
    /// <param name="view">How it was taken.</param>
    /// <returns>Whether it is the reference from now on.</returns>
    public bool Take(bool isSame, in PictureView view)
    {
        double moved = _reference is { } centre ? view.MetresFrom(centre) : 0;
        bool hasMoved = moved > Math.Max(MinMetresMoved, MinPixelsMoved * view.GroundSamplingMetres);
        IsFrozen = isSame && (IsFrozen || hasMoved);
        if (IsFrozen || (_reference is not null && !hasMoved))
            return false;
        _reference = view.Centre;
        return true;
    }
}
