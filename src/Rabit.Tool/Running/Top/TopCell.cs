namespace Rabit.Tool.Running.Top;

/// <summary>One figure; a warning is one that a person should look at.</summary>
internal readonly record struct TopCell(string Text, bool IsWarning = false)
{
    public static implicit operator TopCell(string text) => new(text);
}
