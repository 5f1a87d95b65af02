namespace Rabit.Core.Messages;

/// <summary>A message as the workspace has it, whatever its type.</summary>
internal interface IObservedMessage
{
    MessageObserver Observe();
}
