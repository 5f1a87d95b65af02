using System;

namespace Rabit.Uav.ImageProcessing;

/// <summary>
/// Panels of all classes of a picture; of two that are the same thing the one of two colours, and else the likelier
/// one. Fixed memory.
/// </summary>
internal sealed class PanelChoice
{
    private const int Max = 256;

    private readonly TargetDetection[] _chosen = new TargetDetection[Max];
    private readonly bool[] _hasTwoColours = new bool[Max];
    private int _count;

    /// <summary>Those that are left.</summary>
    public ReadOnlySpan<TargetDetection> Chosen => new(_chosen, 0, _count);

    public void Clear() => _count = 0;

    /// <summary>Adds one, those of two colours first; false where there is no room.</summary>
    public bool TryAdd(in TargetDetection detection, bool hasTwoColours)
    {
        for (int i = 0; i < _count; i++)
        {
            ref TargetDetection other = ref _chosen[i];
            if (Math.Abs(other.CentreX - detection.CentreX) >= Math.Max(other.WidthPixels, detection.WidthPixels) / 2
                || Math.Abs(other.CentreY - detection.CentreY)
                    >= Math.Max(other.HeightPixels, detection.HeightPixels) / 2)
                continue;
            if (_hasTwoColours[i] == hasTwoColours && detection.Score > other.Score)
                other = detection;
            return true;
        }

        if (_count == Max)
            return false;
        _hasTwoColours[_count] = hasTwoColours;
        _chosen[_count++] = detection;
        return true;
    }
}
