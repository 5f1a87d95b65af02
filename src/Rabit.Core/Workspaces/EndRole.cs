namespace Rabit.Core.Workspaces;

/// <summary>What an end does.</summary>
internal enum EndRole
{
    Publish,
    Subscribe,
    Send,
    Receive,
}
