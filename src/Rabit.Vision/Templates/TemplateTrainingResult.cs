namespace Rabit.Vision;

/// <summary>A trained template, and how well such a one does on pictures that it was not trained with.</summary>
public sealed class TemplateTrainingResult
{
    internal TemplateTrainingResult(ObjectTemplate template) => Template = template;

    /// <summary>The template.</summary>
    public ObjectTemplate Template { get; }

    /// <summary>Pictures it was trained with.</summary>
    public int Pictures { get; internal init; }

    /// <summary>Objects it was trained with.</summary>
    public int Objects { get; internal init; }

    /// <summary>Boxes that were ignored: said to be, or too long for the object.</summary>
    public int Ignored { get; internal init; }

    /// <summary>
    /// On how many parts of the pictures it was tried, each left out of a training of its own; 0 where all pictures are
    /// of one group: then nothing is known of how well it does, and its threshold is a guess.
    /// </summary>
    public int Folds { get; internal set; }

    /// <summary>What part of the objects was found on pictures left out, at the threshold of the template.</summary>
    public double Recall { get; internal set; } = double.NaN;

    /// <summary>False alarms for each of those pictures, at the threshold of the template.</summary>
    public double FalseAlarmsPerPicture { get; internal set; } = double.NaN;
}
