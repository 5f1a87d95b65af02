using System.Collections.Generic;
using Rabit.Vision;

namespace Rabit.Tool.Training;

/// <summary>A picture of a file of labels.</summary>
internal sealed class LabelledPicture
{
    public string Path { get; set; } = "";

    /// <summary>What it is called in its file of labels.</summary>
    public string Field { get; set; } = "";

    public double MetresPerPixel { get; set; }

    public string? Group { get; set; }

    public IReadOnlyList<TrainingBox> Boxes { get; set; } = [];
}
