namespace Rabit.Tool.Running.Top;

/// <summary>What is shown.</summary>
internal enum TopSection
{
    All,
    Managers,
    Queues,
    Messages,
}
