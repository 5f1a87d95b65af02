using System.Collections.Generic;
using Rabit.Vision;

namespace Rabit.Tool.Training;

/// <summary>A picture of a file of labels.</summary>
internal sealed class LabelledPicture
{
    public string Path { get; init; } = "";

    public double MetresPerPixel { get; init; }

    public string? Group { get; init; }

    public IReadOnlyList<TrainingBox> Boxes { get; init; } = [];
}
