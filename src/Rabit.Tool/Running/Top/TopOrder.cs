namespace Rabit.Tool.Running.Top;

/// <summary>By what the rows are sorted.</summary>
internal enum TopOrder
{
    /// <summary>Managers as they start, queues and messages by name.</summary>
    Start,
    Name,

    /// <summary>Runs, pushes and posts, the highest first.</summary>
    Rate,

    /// <summary>Load of managers, level of queues, the highest first; messages by age, the youngest first.</summary>
    Load,

    /// <summary>
    /// What went wrong with managers, what queues have lost, the most first; messages by age, the oldest first.
    /// </summary>
    Trouble,
}
