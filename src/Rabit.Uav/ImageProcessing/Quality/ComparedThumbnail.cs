using System;

namespace Rabit.Uav.ImageProcessing.Quality;

/// <summary>
/// A few pixels of each picture, and those of an earlier one that they are compared with: a camera that delivers the
/// same picture again is found by it. Fixed memory, no allocation; for one thread.
/// </summary>
internal sealed class ComparedThumbnail
{
    /// <summary>Most pixels of a row of the grid.</summary>
    public const int MaxColumns = 64;

    /// <summary>Most rows of the grid.</summary>
    public const int MaxRows = 48;

    private const int MinStep = 8;

    private ushort[] _pixels = new ushort[MaxColumns * MaxRows];
    private ushort[] _reference = new ushort[MaxColumns * MaxRows];
    private int _referenceCount;

    /// <summary>Pixels of the picture so far.</summary>
    public int Count { get; private set; }

    /// <summary>How far the pixels of the grid are apart: a pixel in 64, or fewer in a large picture.</summary>
    public static int StepFor(int width, int height) => Math.Max(
        MinStep, Math.Max((width + MaxColumns - 1) / MaxColumns, (height + MaxRows - 1) / MaxRows));

    /// <summary>Begins with another picture.</summary>
    public void Clear() => Count = 0;

    public void Add(int value) => _pixels[Count++] = (ushort)value;

    /// <summary>Takes the picture as the one that later ones are compared with.</summary>
    public void KeepAsReference()
    {
        (_pixels, _reference) = (_reference, _pixels);
        _referenceCount = Count;
    }

    /// <summary>
    /// Mean square of the difference between the picture and the reference; infinite where there is none of its size.
    /// </summary>
    public double DifferenceFromReference()
    {
        if (Count == 0 || Count != _referenceCount)
            return double.PositiveInfinity;
        long sum = 0;
        for (int i = 0; i < Count; i++)
        {
            long difference = _pixels[i] - _reference[i];
            sum += difference * difference;
        }

        return sum / (double)Count;
    }
}
